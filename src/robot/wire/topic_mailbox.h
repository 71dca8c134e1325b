// Large messages on their way from the link's thread to the one that shows them.
#pragma once

#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "map/stamped_message.h"

namespace mapwright::robot::wire {

/// Holds the latest message of each topic until it is taken: what comes faster than it can be shown replaces
/// what was not taken yet. Thread-safe.
class TopicMailbox {
 public:
  static constexpr std::size_t kTopics = 64;  // of more than these nothing is held

  /// Whether messages of this kind go by mail: large, and of no use once a newer one is there.
  static bool takes(const map::TopicMessage& message);

  /// True when the box was empty: the taker has to be woken.
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
