#include "simulator/web_socket_hub.h"

#include <vector>

#include "simulator/web_socket_session.h"

namespace mapwright::simulator {

void WebSocketHub::join(const std::shared_ptr<WebSocketSession>& session) {
  sessions_[session.get()] = session;
  open_ = static_cast<int>(sessions_.size());
}

void WebSocketHub::leave(const WebSocketSession* session) {
  const auto found = sessions_.find(session);
  if (found == sessions_.end()) return;
  const std::shared_ptr<WebSocketSession> last =
      std::move(found->second);  // goes when the books are in order
  sessions_.erase(found);
  open_ = static_cast<int>(sessions_.size());
}

void WebSocketHub::publish(std::string_view topic) {
  for (const auto& [address, session] : std::map(sessions_)) {
    session->publish(topic);
  }
}

void WebSocketHub::drop() {
  for (const auto& [address, session] : std::map(sessions_)) {
    session->cut();
  }
}

}  // namespace mapwright::simulator
