// One client of the simulated rosbridge server. Lives on the server's thread, kept alive by the server and by
// its pending operations.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <string_view>

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>

#include "simulator/ros/fragments.h"
#include "simulator/ros/subscriptions.h"

namespace mapwright::simulator::ros {

class RosServer;

class RosSession : public std::enable_shared_from_this<RosSession> {
 public:
  RosSession(boost::asio::ip::tcp::socket socket, RosServer& server);
  RosSession(const RosSession&) = delete;
  RosSession& operator=(const RosSession&) = delete;

  void accept();
  bool wants(std::string_view topic) const { return subscriptions_.has(topic); }
  /// A message of a topic; what is not subscribed to is left out. `at_once`: without waiting for its
  /// throttle.
  void deliver(const PublicationPtr& message, bool at_once);
  /// Sends what has waited long enough.
  void tick(Subscriptions::Time now);
  /// A frame as it is, whatever it is.
  void sendRaw(std::string bytes, bool binary);
  /// Without a closing handshake.
  void cut();

 private:
  struct Frame {
    std::shared_ptr<const std::string> bytes;
    bool binary = false;
  };
  void read();
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
  void send(Frame frame);
  void write();

  boost::beast::websocket::stream<boost::beast::tcp_stream> stream_;
  RosServer& server_;
  boost::beast::flat_buffer buffer_;
  Subscriptions subscriptions_;
  std::size_t fragment_size_ = 0;
  FragmentShelf shelf_;
  std::string status_level_;  // "error" and the like: told of mistakes
  bool authenticated_ = false;
  bool open_ = false;
  std::uint64_t calls_ = 0;
  std::deque<Frame> outgoing_;
  std::size_t outgoing_bytes_ = 0;
};

}  // namespace mapwright::simulator::ros
