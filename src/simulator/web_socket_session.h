// One client of /ws/v2/topics. Lives on the server's thread, kept alive by the hub and by its pending
// operations.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include "simulator/services.h"

namespace mapwright::simulator {

class WebSocketSession : public std::enable_shared_from_this<WebSocketSession> {
 public:
  using Request = boost::beast::http::request<boost::beast::http::string_body>;

  WebSocketSession(boost::asio::ip::tcp::socket socket, Services services);
  WebSocketSession(const WebSocketSession&) = delete;
  WebSocketSession& operator=(const WebSocketSession&) = delete;

  void accept(const Request& request);
  /// The topic's current message, when it is enabled here.
  void publish(std::string_view topic);
  void cut();

 private:
  void read();
  void understand(std::string_view text);
  void make(const std::string& topic);
  void send(Frame frame);
  void write();

  boost::beast::websocket::stream<boost::beast::tcp_stream> stream_;
  Services services_;
  boost::beast::flat_buffer buffer_;
  Request request_;
  bool binary_ = false;
  bool silent_ = false;
  std::set<std::string, std::less<>> topics_;
  std::map<std::string, bool> making_;  // topics that a worker has; true: publish once more when it is done
  std::deque<Frame> outgoing_;
  std::size_t outgoing_bytes_ = 0;
};

}  // namespace mapwright::simulator
