// A message of a robot with its times, as it goes through the port and into recordings.
#pragma once

#include <optional>
#include <string>

#include "map/live_topics.h"

namespace mapwright::map {

/// Seconds since the epoch.
struct StampedMessage {
  TopicMessage message;
  double received_s = 0;                  // when it arrived: here, or at the recorder
  std::optional<double> recorded_s = {};  // when the robot says that it was true; nullopt = it did not say
  std::string topic = {};                 // as the robot calls it, to be shown; empty = nothing to be shown

  /// The time that the world goes by. A robot's own clock may be wrong by years, but the differences between
  /// its stamps count, and the time of arrival is always there: arrival it is.
  double at_s() const { return received_s; }
  bool operator==(const StampedMessage&) const = default;
};

}  // namespace mapwright::map
