// One client of the simulated rosbridge server: its subscriptions, and when it gets which message
// (docs/protocols/rosbridge.md).
#pragma once

#include <chrono>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simulator/sockets.h"
#include "simulator/value.h"

namespace mapwright::simulator::ros {

class RosServer;

enum class Compression { None, Png, Cbor };

/// A message of a topic, encoded once for all receivers. Of the server's thread.
class Publication {
 public:
  Publication(std::string topic, Value msg, RosWriter writer);

  const std::string& topic() const { return topic_; }
  const std::string& json() const;
  /// {"op":"png","data":...}: the bytes of the JSON, padded with newlines, are the pixels of an RGB picture.
  const std::string& png() const;
  /// nullopt: lost, as servers do.
  const std::optional<std::string>& cbor() const;

 private:
  std::string topic_;
  Value message_;
  RosWriter writer_;
  mutable std::string json_, png_;
  mutable std::optional<std::optional<std::string>> cbor_;
};
using PublicationPtr = std::shared_ptr<const Publication>;

struct Subscription {
  std::string type;  // may be empty
  std::chrono::milliseconds throttle{0};
  std::size_t queue_length = 0;  // 0: early messages are dropped
  Compression compression = Compression::None;
};

/// Pure: time is passed in.
class Subscriptions {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// false if there are too many.
  bool add(const std::string& topic, const std::string& id, Subscription wanted);
  /// Without an id: all of the topic.
  void remove(const std::string& topic, const std::optional<std::string>& id);
  bool has(std::string_view topic) const { return topics_.find(topic) != topics_.end(); }
  /// nullopt if it is not subscribed. Of several, the smallest throttle and queue.
  std::optional<Subscription> of(std::string_view topic) const;

  /// Whether to send a message now; otherwise it waits as far as the queue allows.
  bool admit(const PublicationPtr& message, Time now);
  /// Messages that have waited long enough.
  std::vector<PublicationPtr> due(Time now);

 private:
  struct Topic {
    std::map<std::string, Subscription> by_id;
    Time free_at{};
    std::deque<PublicationPtr> waiting;
  };
  static Subscription merged(const Topic& topic);

  std::map<std::string, Topic, std::less<>> topics_;
};

class RosSession : public WebSocketLink {
 public:
  RosSession(Connection& connection, RosServer& server);

  bool wants(std::string_view topic) const { return subscriptions_.has(topic); }
  /// A message of a topic; ignored without a subscription. `at_once`: ignores the throttle.
  void deliver(const PublicationPtr& message, bool at_once);
  /// Sends messages that have waited long enough.
  void tick(Subscriptions::Time now);

 private:
  /// Fragments sent by a client, joined by id, in any order.
  struct Fragments {
    std::size_t total = 0, bytes = 0;
    std::map<std::size_t, std::string> pieces;
  };

  bool opened() override;
  void onMessage(const std::string& text, bool is_text) override;
  void gone() override;
  std::shared_ptr<RosSession> self() { return std::static_pointer_cast<RosSession>(shared_from_this()); }
  void understand(std::string_view text, bool joined = false);
  void join(const Value& piece);
  void subscribe(const Value& message);
  void unsubscribe(const Value& message);
  void publish(const Value& message);
  void call(const Value& message);
  void answer(const std::string& service, const Value& id, bool worked, Value values, int delay_ms);
  void complain(std::string_view sentence, const Value& id);
  void encode(const Publication& message);
  void sendText(std::string text, const Value& id);

  RosServer& server_;
  Subscriptions subscriptions_;
  std::size_t fragment_size_ = 0;
  std::map<std::string, Fragments> fragments_;
  std::string status_level_;  // level of status messages, such as "error"
  bool authenticated_ = false;
  std::uint64_t calls_ = 0;
};

}  // namespace mapwright::simulator::ros
