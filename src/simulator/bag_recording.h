// What a bag holds: the robot's own topics, as they were at their times (axbot.md, the bag player).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "simulator/robot_state.h"
#include "simulator/stored_map.h"

namespace mapwright::simulator {

/// Simulated seconds.
struct BagSpan {
  double from_s = 0, until_s = 0;
  bool every_scan = false;  // recorded to find out about positioning
  bool operator==(const BagSpan&) const = default;
};

/// A pure function of the scene, the seed and the span: what is edited afterwards does not change the past.
class BagRecording {
 public:
  /// `state` is only asked for its past; `map` is what the robot worked with.
  BagRecording(const RobotState& state, std::optional<StoredMap> map, std::uint32_t seed, BagSpan span);

  std::size_t messages() const { return ticks_.size(); }
  /// Of the first and the last message, in whole seconds of the epoch as these robots tell it: the last
  /// message may lie after endTime().
  std::int64_t startTime() const;
  std::int64_t endTime() const;
  /// A JSON list of the messages in [from, until] (epoch seconds), oldest first. Before them what was said
  /// last on each latched topic.
  std::string messagesJson(double from, double until) const;

 private:
  struct Tick {
    std::int64_t stamp_ms = 0;  // of the epoch
    std::size_t topic = 0;
  };

  std::string textOf(const Tick& tick) const;

  const RobotState& state_;
  const std::optional<StoredMap> map_;
  const std::uint32_t seed_;
  std::vector<Tick> ticks_;  // ascending
};

}  // namespace mapwright::simulator
