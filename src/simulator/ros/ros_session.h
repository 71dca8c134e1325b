// One client of the simulated rosbridge server.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "simulator/ros/fragments.h"
#include "simulator/ros/subscriptions.h"
#include "simulator/web_socket_link.h"

namespace mapwright::simulator::ros {

class RosServer;

class RosSession : public WebSocketLink {
 public:
  RosSession(Connection& connection, RosServer& server);

  bool wants(std::string_view topic) const { return subscriptions_.has(topic); }
  /// A message of a topic; ignored without a subscription. `at_once`: ignores the throttle.
  void deliver(const PublicationPtr& message, bool at_once);
  /// Sends messages that have waited long enough.
  void tick(Subscriptions::Time now);

 private:
  bool opened() override;
  void take(const std::string& text, bool is_text) override;
  void gone() override;
  std::shared_ptr<RosSession> self() { return std::static_pointer_cast<RosSession>(shared_from_this()); }
  void understand(std::string_view text, bool joined = false);
  void subscribe(const Value& message);
  void unsubscribe(const Value& message);
  void publish(const Value& message);
  void call(const Value& message);
  void answer(const std::string& service, const Value& id, bool worked, Value values);
  void sendLater(std::string text, const Value& id, std::chrono::milliseconds delay);
  void complain(std::string_view sentence, const Value& id);
  void encode(const Publication& message);
  void sendText(std::string text, const Value& id);

  RosServer& server_;
  Subscriptions subscriptions_;
  std::size_t fragment_size_ = 0;
  FragmentShelf shelf_;
  std::string status_level_;  // level of status messages, such as "error"
  bool authenticated_ = false;
  std::uint64_t calls_ = 0;
};

}  // namespace mapwright::simulator::ros
