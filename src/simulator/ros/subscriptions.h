// The subscriptions of a client, and when it gets which message (docs/protocols/rosbridge.md, "Topics").
#pragma once

#include <chrono>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simulator/ros/ros_options.h"
#include "simulator/value.h"

namespace mapwright::simulator::ros {

enum class Compression { None, Png, Cbor };

/// A message of a topic, encoded once for all receivers. Of the server's thread.
class Publication {
 public:
  Publication(std::string topic, Value msg, RosWriter writer);

  const std::string& topic() const { return topic_; }
  const std::string& json() const;
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
  bool take(const PublicationPtr& message, Time now);
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

}  // namespace mapwright::simulator::ros
