// The open WebSockets and what is sent to all of them. Keeps them alive; lives on the server's thread.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <string_view>

namespace mapwright::simulator {

class WebSocketSession;

class WebSocketHub {
 public:
  void join(const std::shared_ptr<WebSocketSession>& session);
  void leave(const WebSocketSession* session);
  /// To everyone who has the topic enabled.
  void publish(std::string_view topic);
  /// Cuts every connection, without a closing handshake.
  void drop();
  /// From any thread.
  int open() const { return open_; }

 private:
  std::map<const WebSocketSession*, std::shared_ptr<WebSocketSession>> sessions_;
  std::atomic<int> open_ = 0;
};

}  // namespace mapwright::simulator
