// The content of a simulated bag: the robot's own topics at their times (docs/protocols/autoxing.md, "Bags").
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "simulator/robot_state.h"
#include "simulator/stored_map.h"

namespace mapwright::simulator {

/// What is unusual about a bag.
enum class BagQuirk {
  None,
  ClockSetBack,  // by two minutes, in its middle: later messages have earlier stamps
  SameStamps,    // the clock only tells half seconds
  Gap,           // nothing was recorded in its middle
  EndsLate,      // it continues for half a minute after its stated end
  OneMessage,
  Empty,
};

/// Simulated seconds.
struct BagSpan {
  double from_s = 0, until_s = 0;
  bool every_scan = false;  // recorded to diagnose localization
  BagQuirk quirk = BagQuirk::None;
  bool operator==(const BagSpan&) const = default;
};

/// A pure function of scene, seed and time span: later edits do not change the past.
class BagRecording {
 public:
  /// `state` is only used for its past; `map` is the robot's map at that time.
  BagRecording(const RobotState& state, std::optional<StoredMap> map, std::uint32_t seed, BagSpan span);

  std::size_t messages() const { return ticks_.size(); }
  /// Of the first and the last message, in whole seconds of the epoch as these robots give it: the last
  /// message may be after endTime().
  std::int64_t startTime() const;
  std::int64_t endTime() const;
  enum class End { Inclusive, Exclusive };
  /// A JSON list of the messages in [from, until] (epoch seconds), preceded by the last one of each latched
  /// topic. Only these are generated.
  std::string messagesJson(double from, double until, End end = End::Inclusive) const;

 private:
  struct Tick {
    std::int64_t stamp_ms = 0;  // of the epoch, by the robot's clock
    std::int64_t true_ms = 0;   // as it was
    std::size_t topic = 0;
  };

  std::string textOf(const Tick& tick) const;

  const RobotState& state_;
  const std::optional<StoredMap> map_;
  const std::uint32_t seed_;
  void apply(BagQuirk quirk);

  std::vector<Tick> ticks_;    // as recorded
  std::int64_t silent_s_ = 0;  // after the stated end
};

}  // namespace mapwright::simulator
