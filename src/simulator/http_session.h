// One HTTP connection: requests one after the other until it closes or becomes a WebSocket. Lives on the
// server's thread, kept alive by its pending operations.
#pragma once

#include <memory>
#include <optional>

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>

#include "simulator/services.h"

namespace mapwright::simulator {

class HttpSession : public std::enable_shared_from_this<HttpSession> {
 public:
  HttpSession(boost::asio::ip::tcp::socket socket, Services services);

  void read();

 private:
  using Body = boost::beast::http::span_body<const char>;

  void take();
  void work(const HttpQuestion& question);
  void give();
  void wait();
  void watchPeer();
  void respond();
  void close();

  boost::beast::tcp_stream stream_;
  boost::asio::steady_timer timer_;
  Services services_;
  boost::beast::flat_buffer buffer_;
  std::optional<boost::beast::http::request_parser<boost::beast::http::string_body>> parser_;
  std::optional<LoggedRequest> logged_;
  HttpAnswer answer_;
  bool keep_alive_ = true;
  bool head_only_ = false;
  std::optional<boost::beast::http::response<Body>> response_;
};

}  // namespace mapwright::simulator
