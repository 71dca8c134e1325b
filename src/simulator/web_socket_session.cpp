#include "simulator/web_socket_session.h"

#include <boost/asio/post.hpp>
#include <boost/asio/thread_pool.hpp>

#include "simulator/http_answer.h"
#include "simulator/json_text.h"
#include "simulator/topic_request.h"
#include "simulator/topic_schedule.h"

namespace mapwright::simulator {
namespace {

namespace beast = boost::beast;
namespace websocket = boost::beast::websocket;

constexpr std::size_t kMostMessageBytes = 64 << 10;
constexpr std::size_t kMostTopics = 256;
constexpr std::size_t kMostQueued = 32;                           // beyond it, what comes again is left out
constexpr std::size_t kMostQueuedBytes = std::size_t{256} << 20;  // beyond it, the reader is given up

std::string errorMessage(std::string_view sentence) {
  std::string out = "{\"error\":";
  appendJsonText(out, sentence);
  out += '}';
  return out;
}

}  // namespace

WebSocketSession::WebSocketSession(boost::asio::ip::tcp::socket socket, Services services)
    : stream_(std::move(socket)), services_(services) {}

void WebSocketSession::accept(const Request& request) {
  request_ = request;
  const std::string_view target(request_.target().data(), request_.target().size());
  binary_ = services_.options.binary_topics && queryValue(target, "pb") == "1";
  silent_ = services_.faults.faults().silent_websocket;
  beast::get_lowest_layer(stream_).expires_never();
  websocket::stream_base::timeout timeout{};
  timeout.handshake_timeout = std::chrono::seconds(10);
  timeout.idle_timeout = websocket::stream_base::none();
  timeout.keep_alive_pings = false;
  stream_.set_option(timeout);
  stream_.read_message_max(kMostMessageBytes);
  stream_.async_accept(request_, [self = shared_from_this()](beast::error_code error) {
    if (error) return;
    self->services_.hub.join(self);
    if (!self->silent_) self->read();  // who does not read does not pong either
  });
}

void WebSocketSession::read() {
  stream_.async_read(buffer_, [self = shared_from_this()](beast::error_code error, std::size_t) {
    if (error) {
      self->services_.hub.leave(self.get());
      self->topics_.clear();
      return;
    }
    const auto bytes = self->buffer_.data();
    const std::string text(static_cast<const char*>(bytes.data()), bytes.size());
    self->buffer_.consume(self->buffer_.size());
    if (self->stream_.got_text()) {
      self->understand(text);
    } else {
      self->send(textFrame(errorMessage("Binary messages are not understood.")));
    }
    self->read();
  });
}

void WebSocketSession::understand(std::string_view text) {
  const TopicRequest request = parseTopicRequest(text, services_.options.enable_topic_list);
  if (!request.problem.empty()) {
    send(textFrame(errorMessage(request.problem)));
    return;
  }
  for (const std::string& topic : request.enable) {
    if (topics_.size() < kMostTopics) topics_.insert(topic);
  }
  for (const std::string& topic : request.disable) topics_.erase(topic);
  std::string reply = "{\"enabled_topics\":[";
  for (const std::string& topic : topics_) {
    if (reply.back() != '[') reply += ',';
    appendJsonText(reply, topic);
  }
  send(textFrame(reply + "]}"));
  for (const std::string& topic : request.enable) {
    if (isLatched(topic)) publish(topic);
  }
}

void WebSocketSession::publish(std::string_view topic) {
  if (!topics_.contains(topic)) return;
  const Faults faults = services_.faults.faults();
  if (silent_ || faults.silent_websocket) return;
  if (mayBeLeftOut(topic) && outgoing_.size() > kMostQueued) return;
  if (isSlow(topic)) {
    make(std::string(topic));
    return;
  }
  if (std::optional<Frame> frame = services_.messages.messageOf(topic, binary_, faults.bad_entries)) {
    send(std::move(*frame));
  }
}

void WebSocketSession::make(const std::string& topic) {
  const auto [entry, is_new] = making_.try_emplace(topic, false);
  if (!is_new) {
    entry->second = true;
    return;
  }
  boost::asio::post(services_.workers, [self = shared_from_this(), topic] {
    std::optional<Frame> frame = self->services_.messages.messageOf(topic, self->binary_, false);
    boost::asio::post(self->stream_.get_executor(), [self, topic, frame = std::move(frame)]() mutable {
      const bool again = self->making_.extract(topic).mapped();
      if (frame && self->topics_.contains(topic)) self->send(std::move(*frame));
      if (again) self->publish(topic);
    });
  });
}

void WebSocketSession::send(Frame frame) {
  outgoing_bytes_ += frame.bytes->size();
  if (outgoing_bytes_ > kMostQueuedBytes) {
    cut();
    return;
  }
  outgoing_.push_back(std::move(frame));
  if (outgoing_.size() == 1) write();
}

void WebSocketSession::write() {
  stream_.binary(outgoing_.front().binary);
  stream_.async_write(boost::asio::buffer(*outgoing_.front().bytes),
                      [self = shared_from_this()](beast::error_code error, std::size_t) {
                        if (error) {
                          self->cut();
                          return;
                        }
                        self->outgoing_bytes_ -= self->outgoing_.front().bytes->size();
                        self->outgoing_.pop_front();
                        if (!self->outgoing_.empty()) self->write();
                      });
}

void WebSocketSession::cut() {
  services_.hub.leave(this);
  topics_.clear();
  beast::error_code ignored;  // it is being given up either way
  beast::get_lowest_layer(stream_).socket().shutdown(boost::asio::ip::tcp::socket::shutdown_both, ignored);
  beast::get_lowest_layer(stream_).close();
}

}  // namespace mapwright::simulator
