// Passes large messages from the link's thread to the one that shows them.
#pragma once

#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "map/live_topics.h"

namespace mapwright::robot::wire {

/// Keeps the latest message of each topic until it is taken: messages that arrive faster than they are shown
/// replace each other. Thread-safe.
class TopicMailbox {
 public:
  static constexpr std::size_t kTopics = 64;  // further topics are dropped

  /// Whether messages of this kind use the mailbox: large, and useless once there is a newer one.
  static bool takes(const map::TopicMessage& message);

  /// True if the box was empty: the receiver has to be woken.
  bool put(map::StampedMessage message);
  /// Empties the box.
  std::vector<map::StampedMessage> take();
  /// How many were replaced before they were taken.
  std::size_t replaced() const;

 private:
  mutable std::mutex mutex_;
  std::size_t replaced_ = 0;
  std::map<std::string, map::StampedMessage> latest_;  // by topic
};

}  // namespace mapwright::robot::wire
