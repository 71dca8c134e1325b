// A message of a robot with its times, as passed through the port and stored in recordings.
#pragma once

#include <optional>
#include <string>

#include "map/live_topics.h"

namespace mapwright::map {

/// Seconds since the epoch.
struct StampedMessage {
  TopicMessage message;
  double received_s = 0;                  // when it arrived here, or at the recorder
  std::optional<double> recorded_s = {};  // the robot's own time stamp; nullopt = none
  std::string topic = {};                 // the robot's name for it, for display; empty = not displayed

  /// The time used for the world. A robot's clock may be wrong by years, while the time of arrival is always
  /// known, so that one is used.
  double at_s() const { return received_s; }
  bool operator==(const StampedMessage&) const = default;
};

}  // namespace mapwright::map
