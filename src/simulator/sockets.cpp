#include "simulator/sockets.h"

#include <future>
#include <list>
#include <optional>
#include <thread>

// Both src.hpp are the functions that need be compiled once only (their separate compilation).
#include <boost/asio/basic_socket_acceptor.hpp>
#include <boost/asio/basic_waitable_timer.hpp>
#include <boost/asio/impl/src.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/src.hpp>
#include <boost/beast/websocket.hpp>

#include "simulator/axbot_routes.h"

namespace mapwright::simulator {

namespace beast = boost::beast;
namespace http = boost::beast::http;
namespace websocket = boost::beast::websocket;
using boost::asio::ip::tcp;

// One executor type and one handler type per operation, since Boost instantiates everything for each
// combination.
using Executor = boost::asio::io_context::executor_type;
using Socket = boost::asio::basic_stream_socket<tcp, Executor>;
using Stream = beast::basic_stream<tcp, Executor>;
using Clock = std::chrono::steady_clock;
using Timer = boost::asio::basic_waitable_timer<Clock, boost::asio::wait_traits<Clock>, Executor>;
using HttpParser = http::request_parser<http::string_body>;

using ErrorCode = beast::error_code;
using Transferred = std::function<void(ErrorCode, std::size_t)>;
using Waited = std::function<void(ErrorCode)>;

using Acceptor = boost::asio::basic_socket_acceptor<tcp, Executor>;
using OnConnection = std::function<void(Connection&)>;

struct Connection {
  Socket socket;
};
struct Handshake {
  HttpParser::value_type request;
};

namespace {

constexpr auto kHandshake = std::chrono::seconds(10);
constexpr std::uint32_t kMostHeaderBytes = 16 << 10;
constexpr std::uint64_t kMostBodyBytes = 64 << 20;  // a map with its picture
constexpr auto kIdle = std::chrono::seconds(60);
constexpr std::string_view kTopicsPath = "/ws/v2/topics";

void readHttp(Stream& stream, beast::flat_buffer& buffer, HttpParser& parser, Transferred done) {
  beast::http::async_read(stream, buffer, parser, std::move(done));
}

void shutDown(Stream& stream) {
  ErrorCode ignored;  // the connection ends either way
  stream.socket().shutdown(tcp::socket::shutdown_both, ignored);
  stream.close();
}

std::string_view view(beast::string_view text) { return {text.data(), text.size()}; }

/// Kept alive by its pending operations.
class HttpSession : public std::enable_shared_from_this<HttpSession> {
 public:
  HttpSession(Socket socket, const HttpService& service)
      : stream_(std::move(socket)), timer_(stream_.get_executor()), service_(service) {}

  void read() {
    parser_.emplace();
    parser_->header_limit(kMostHeaderBytes);
    parser_->body_limit(kMostBodyBytes);
    stream_.expires_after(kIdle);
    readHttp(stream_, buffer_, *parser_, [self = shared_from_this()](ErrorCode error, std::size_t) {
      self->stream_.expires_never();
      if (!error) {
        self->onRequest();
        return;
      }
      const bool refused = error == http::error::header_limit || error == http::error::body_limit;
      const bool unreadable = error.category() == make_error_code(http::error::bad_target).category() &&
                              error != http::error::end_of_stream && error != http::error::partial_message;
      if (!refused && !unreadable) {
        shutDown(self->stream_);
        return;
      }
      const int status = error == http::error::header_limit ? 431
                         : error == http::error::body_limit ? 413
                                                            : 400;
      self->answer_ = errorAnswer(status, "The request is too large or no HTTP.");
      self->keep_alive_ = false;
      self->respond();
    });
  }

 private:
  void onRequest() {
    const auto& request = parser_->get();
    const std::string_view target = view(request.target()), path = pathOf(target);
    HttpQuestion question{view(request.method_string()),
                          target,
                          view(request["Secret"]),
                          view(request[http::field::if_none_match]),
                          request.body(),
                          view(request[http::field::content_type]),
                          view(request[http::field::range]),
                          view(request[http::field::if_range])};
    RequestRecord record;
    record.method = question.method;
    record.target = target;
    record.had_secret = request.find("Secret") != request.end();
    record.if_none_match = question.if_none_match;
    keep_alive_ = request.keep_alive();
    head_only_ = request.method() == http::verb::head;
    logged_.emplace(service_.log, record, isSubmapPath(path));
    const bool wants_upgrade = beast::websocket::is_upgrade(request);
    if (wants_upgrade) keep_alive_ = false;  // what follows a refused handshake is no HTTP
    if (path == kTopicsPath && question.method == "GET" && service_.routes.opensTopics(question.secret)) {
      if (wants_upgrade) {
        logged_->finish(101, 0);
        Connection connection{stream_.release_socket()};
        service_.open_topics(connection, target)->accept({request});
        return;
      }
      answer_ = errorAnswer(400, "This address speaks WebSocket only.");
    } else if (service_.routes.isSlow(path)) {
      work(question);
      return;
    } else {
      answer_ = service_.routes.answer(question);
    }
    give();
  }

  void work(const HttpQuestion& question) {
    // The question's texts lie in the parser, which stays as it is until the answer is sent.
    service_.loop.work([self = shared_from_this(), question] {
      auto answer = std::make_shared<HttpAnswer>(self->service_.routes.answer(question));
      self->service_.loop.post([self, answer] {
        self->answer_ = std::move(*answer);
        self->give();
      });
    });
  }

  void give() { answer_.delay_ms > 0 ? wait() : respond(); }

  void wait() {
    timer_.expires_after(std::chrono::milliseconds(answer_.delay_ms));
    timer_.async_wait(Waited([self = shared_from_this()](ErrorCode error) {
      if (error) return;
      ErrorCode ignored;  // only ends watchPeer
      self->stream_.socket().cancel(ignored);
      self->respond();
    }));
    watchPeer();
  }

  void watchPeer() {
    // A client that hangs up while it waits is no request in progress any more.
    stream_.socket().async_wait(Socket::wait_read, [self = shared_from_this()](ErrorCode error) {
      if (error) return;
      char byte = 0;
      self->stream_.socket().non_blocking(true, error);
      const std::size_t seen =
          self->stream_.socket().receive(boost::asio::buffer(&byte, 1), Socket::message_peek, error);
      if (seen > 0 || error == boost::asio::error::would_block) return;
      self->timer_.cancel();
      self->logged_.reset();
      shutDown(self->stream_);
    });
  }

  void respond() {
    if (answer_.drop) {
      logged_.reset();
      shutDown(stream_);
      return;
    }
    response_.emplace();
    response_->version(11);
    response_->result(static_cast<unsigned>(answer_.status));
    response_->set(http::field::server, "axbot");
    if (!answer_.content_type.empty()) response_->set(http::field::content_type, answer_.content_type);
    for (const auto& [name, value] : answer_.headers) response_->set(name, value);
    const std::size_t whole = answer_.body ? answer_.body->size() : 0;
    const std::size_t sent = head_only_ ? 0 : answer_.truncate ? whole / 2 : whole;
    if (answer_.status != 304 && answer_.status != 204) response_->content_length(whole);
    response_->keep_alive(keep_alive_);
    if (sent > 0) response_->body() = {answer_.body->data(), sent};
    stream_.expires_after(kIdle);
    http::async_write(stream_, *response_, [self = shared_from_this(), sent](ErrorCode error, std::size_t) {
      self->stream_.expires_never();
      if (self->logged_) {
        self->logged_->finish(error ? 0 : self->answer_.status, error ? 0 : sent);
        self->logged_.reset();
      }
      const bool go_on = !error && self->keep_alive_ && !self->answer_.truncate;
      self->answer_ = {};
      if (go_on) {
        self->read();
      } else {
        shutDown(self->stream_);
      }
    });
  }

  Stream stream_;
  Timer timer_;
  const HttpService& service_;
  beast::flat_buffer buffer_;
  std::optional<HttpParser> parser_;
  std::optional<LoggedRequest> logged_;
  HttpAnswer answer_;
  bool keep_alive_ = true;
  bool head_only_ = false;
  std::optional<http::response<http::span_body<const char>>> response_;
};

}  // namespace

struct Loop::Impl {
  explicit Impl(std::size_t count) : workers(count) {}

  void accept(Acceptor& acceptor, OnConnection on_connection) {
    acceptor.async_accept(
        [this, &acceptor, on_connection = std::move(on_connection)](ErrorCode error, Socket socket) mutable {
          if (error == boost::asio::error::operation_aborted) return;
          if (!error) {
            socket.set_option(tcp::no_delay(true), error);
            Connection connection{std::move(socket)};
            on_connection(connection);
          }
          accept(acceptor, std::move(on_connection));
        });
  }

  boost::asio::io_context io{1};
  boost::asio::thread_pool workers;
  std::list<Acceptor> acceptors;
  std::thread thread;
};

Loop::Loop(std::size_t workers) : impl_(std::make_unique<Impl>(workers)) {}

Loop::~Loop() { stop(); }

tl::expected<std::uint16_t, std::string> Loop::listen(std::uint16_t port, const std::string& whose,
                                                      OnConnection on_connection) {
  Acceptor& acceptor = impl_->acceptors.emplace_back(impl_->io);
  ErrorCode error;
  const tcp::endpoint endpoint(boost::asio::ip::address_v4::loopback(), port);
  std::uint16_t opened = 0;
  acceptor.open(endpoint.protocol(), error);
  if (!error) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
  if (!error) acceptor.bind(endpoint, error);
  if (!error) acceptor.listen(boost::asio::socket_base::max_listen_connections, error);
  if (!error) opened = acceptor.local_endpoint(error).port();
  if (error) {
    return tl::make_unexpected(whose + " could not open port " + std::to_string(port) + " on 127.0.0.1: " +
                               error.message() + ". Choose another port, or 0 for a free one.");
  }
  impl_->accept(acceptor, std::move(on_connection));
  return opened;
}

void Loop::start() {
  impl_->thread = std::thread([this] { impl_->io.run(); });
}

bool Loop::isStarted() const { return impl_->thread.joinable(); }

void Loop::stop() {
  impl_->io.stop();
  if (impl_->thread.joinable()) impl_->thread.join();
  impl_->workers.stop();
  impl_->workers.join();
}

void Loop::post(std::function<void()> task) { boost::asio::post(impl_->io.get_executor(), std::move(task)); }

void Loop::postAndWait(const std::function<void()>& task) {
  const auto promise = std::make_shared<std::promise<void>>();
  post([task, promise] {
    task();
    promise->set_value();
  });
  promise->get_future().wait();
}

void Loop::postAt(std::chrono::steady_clock::time_point time, std::function<void()> task) {
  const auto timer = std::make_shared<Timer>(impl_->io, time);
  timer->async_wait(Waited([timer, task = std::move(task)](ErrorCode error) {
    if (!error) task();
  }));
}

void Loop::work(std::function<void()> task) {
  boost::asio::post(impl_->workers.get_executor(), std::move(task));
}

struct WebSocketLink::Wire {
  explicit Wire(Socket socket) : stream(std::move(socket)) {}

  websocket::stream<Stream, false> stream;
  beast::flat_buffer buffer;
  HttpParser parser;
  Handshake handshake;
};

WebSocketLink::WebSocketLink(Connection& connection, std::size_t most_message_bytes,
                             std::size_t most_queued_bytes)
    : wire_(std::make_unique<Wire>(std::move(connection.socket))), most_queued_bytes_(most_queued_bytes) {
  websocket::stream_base::timeout timeout{};
  timeout.handshake_timeout = kHandshake;
  timeout.idle_timeout = websocket::stream_base::none();
  timeout.keep_alive_pings = false;
  wire_->stream.set_option(timeout);
  wire_->stream.read_message_max(most_message_bytes);
}

WebSocketLink::~WebSocketLink() = default;

void WebSocketLink::accept() {
  wire_->stream.next_layer().expires_after(kHandshake);
  readHttp(wire_->stream.next_layer(), wire_->buffer, wire_->parser,
           [self = shared_from_this()](ErrorCode error, std::size_t) {
             self->wire_->stream.next_layer().expires_never();
             if (!error) self->accept({self->wire_->parser.release()});
           });
}

void WebSocketLink::accept(Handshake handshake) {
  wire_->handshake = std::move(handshake);
  wire_->stream.async_accept(wire_->handshake.request, Waited([self = shared_from_this()](ErrorCode error) {
                               if (error) return;
                               self->open_ = true;
                               if (self->opened()) self->read();
                             }));
}

void WebSocketLink::read() {
  wire_->stream.async_read(wire_->buffer,
                           Transferred([self = shared_from_this()](ErrorCode error, std::size_t) {
                             if (error) {
                               self->open_ = false;
                               return self->gone();
                             }
                             const auto bytes = self->wire_->buffer.data();
                             const std::string text(static_cast<const char*>(bytes.data()), bytes.size());
                             self->wire_->buffer.consume(self->wire_->buffer.size());
                             self->onMessage(text, self->wire_->stream.got_text());
                             if (self->open_) self->read();
                           }));
}

void WebSocketLink::send(Frame frame) {
  if (!open_) return;
  outgoing_bytes_ += frame.bytes->size();
  if (outgoing_bytes_ > most_queued_bytes_) return cut();
  outgoing_.push_back(std::move(frame));
  if (outgoing_.size() == 1) write();
}

void WebSocketLink::write() {
  wire_->stream.binary(outgoing_.front().binary);
  wire_->stream.async_write(boost::asio::buffer(*outgoing_.front().bytes),
                            Transferred([self = shared_from_this()](ErrorCode error, std::size_t) {
                              if (error) return self->cut();
                              self->outgoing_bytes_ -= self->outgoing_.front().bytes->size();
                              self->outgoing_.pop_front();
                              if (!self->outgoing_.empty()) self->write();
                            }));
}

void WebSocketLink::cut() {
  open_ = false;
  gone();
  shutDown(wire_->stream.next_layer());
}

void serveHttp(Connection& connection, const HttpService& service) {
  std::make_shared<HttpSession>(std::move(connection.socket), service)->read();
}

}  // namespace mapwright::simulator
