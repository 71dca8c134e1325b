// One client of /ws/v2/topics.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include "simulator/services.h"
#include "simulator/web_socket_link.h"

namespace mapwright::simulator {

class WebSocketSession : public WebSocketLink {
 public:
  /// `target`: what the handshake asks for.
  WebSocketSession(Connection& connection, Services services, std::string_view target);

  /// The topic's current message, when it is enabled here.
  void publish(std::string_view topic);

 private:
  bool opened() override;
  void take(const std::string& text, bool is_text) override;
  void gone() override;
  std::shared_ptr<WebSocketSession> self() {
    return std::static_pointer_cast<WebSocketSession>(shared_from_this());
  }
  void make(const std::string& topic);

  Services services_;
  const bool binary_, silent_;
  std::set<std::string, std::less<>> topics_;
  std::map<std::string, bool> making_;  // topics that a worker has; true: publish once more when it is done
};

}  // namespace mapwright::simulator
