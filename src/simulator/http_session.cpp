#include "simulator/http_session.h"

#include <chrono>

#include <boost/beast/websocket/rfc6455.hpp>

#include "simulator/boost_sockets.h"
#include "simulator/json_text.h"
#include "simulator/routes.h"
#include "simulator/web_socket_session.h"

namespace mapwright::simulator {
namespace {

namespace beast = boost::beast;
namespace http = boost::beast::http;

constexpr std::uint32_t kMostHeaderBytes = 16 << 10;
constexpr std::uint64_t kMostBodyBytes = 64 << 20;  // a map with its picture
constexpr auto kIdle = std::chrono::seconds(60);
constexpr std::string_view kTopicsPath = "/ws/v2/topics";

std::string_view view(beast::string_view text) { return {text.data(), text.size()}; }

/// Kept alive by its pending operations.
class HttpSession : public std::enable_shared_from_this<HttpSession> {
 public:
  HttpSession(Socket socket, const Services& services);

  void read();

 private:
  using Body = boost::beast::http::span_body<const char>;

  void take();
  void work(const HttpQuestion& question);
  void give();
  void wait();
  void watchPeer();
  void respond();

  Stream stream_;
  Timer timer_;
  Services services_;
  boost::beast::flat_buffer buffer_;
  std::optional<HttpParser> parser_;
  std::optional<LoggedRequest> logged_;
  HttpAnswer answer_;
  bool keep_alive_ = true;
  bool head_only_ = false;
  std::optional<boost::beast::http::response<Body>> response_;
};

HttpSession::HttpSession(Socket socket, const Services& services)
    : stream_(std::move(socket)), timer_(stream_.get_executor()), services_(services) {}

void HttpSession::read() {
  parser_.emplace();
  parser_->header_limit(kMostHeaderBytes);
  parser_->body_limit(kMostBodyBytes);
  stream_.expires_after(kIdle);
  readHttp(stream_, buffer_, *parser_, [self = shared_from_this()](ErrorCode error, std::size_t) {
    self->stream_.expires_never();
    if (!error) {
      self->take();
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

void HttpSession::take() {
  const auto& request = parser_->get();
  const std::string_view target = view(request.target()), path = pathOf(target);
  HttpQuestion question{view(request.method_string()),
                        target,
                        view(request["Secret"]),
                        view(request[http::field::if_none_match]),
                        request.body(),
                        view(request[http::field::content_type]),
                        view(request[http::field::range])};
  RequestRecord record;
  record.method = question.method;
  record.target = target;
  record.had_secret = request.find("Secret") != request.end();
  record.if_none_match = question.if_none_match;
  keep_alive_ = request.keep_alive();
  head_only_ = request.method() == http::verb::head;
  logged_.emplace(services_.log, record, isSubmapPath(path));
  const bool wants_upgrade = beast::websocket::is_upgrade(request);
  if (wants_upgrade) keep_alive_ = false;  // what follows a refused handshake is no HTTP
  if (path == kTopicsPath && question.method == "GET" && services_.routes.opensTopics(question.secret)) {
    if (wants_upgrade) {
      logged_->finish(101, 0);
      Connection connection{stream_.release_socket()};
      std::make_shared<WebSocketSession>(connection, services_, target)->accept({request});
      return;
    }
    answer_ = errorAnswer(400, "This address speaks WebSocket only.");
  } else if (services_.routes.isSlow(path)) {
    work(question);
    return;
  } else {
    answer_ = services_.routes.answer(question);
  }
  give();
}

void HttpSession::work(const HttpQuestion& question) {
  // The question's texts lie in the parser, which stays as it is until the answer is sent.
  services_.loop.work([self = shared_from_this(), question] {
    auto answer = std::make_shared<HttpAnswer>(self->services_.routes.answer(question));
    self->services_.loop.post([self, answer] {
      self->answer_ = std::move(*answer);
      self->give();
    });
  });
}

void HttpSession::give() {
  if (answer_.delay_ms > 0) {
    wait();
  } else {
    respond();
  }
}

void HttpSession::wait() {
  timer_.expires_after(std::chrono::milliseconds(answer_.delay_ms));
  timer_.async_wait(Waited([self = shared_from_this()](ErrorCode error) {
    if (error) return;
    ErrorCode ignored;  // only ends watchPeer
    self->stream_.socket().cancel(ignored);
    self->respond();
  }));
  watchPeer();
}

void HttpSession::watchPeer() {
  // A client that hangs up while it waits is no request under way any more.
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

void HttpSession::respond() {
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

}  // namespace

void serveHttp(Connection& connection, const Services& services) {
  std::make_shared<HttpSession>(std::move(connection.socket), services)->read();
}

}  // namespace mapwright::simulator
