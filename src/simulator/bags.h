// The recordings of the simulated robot (docs/protocols/autoxing.md, "Bags"): bags continuously, recordings
// on demand.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "simulator/maps.h"
#include "simulator/robot_state.h"

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
  Damaged,     // in its middle: a range that contains that second is refused with 400
  Unreadable,  // the same, with 500
  Uncounted,   // its number of messages is left out
  Latched,     // all that robots latch in bags is in it
};

/// Simulated seconds.
struct BagSpan {
  double from_s = 0, until_s = 0;
  bool every_scan = false;  // recorded to diagnose localization
  BagQuirk quirk = BagQuirk::None;
  bool operator==(const BagSpan&) const = default;
};

enum class BagFolder { Bags, Recordings };
enum class BagCondition { Whole, Recording, Corrupt };

struct Bag {
  std::string name;
  BagSpan span;
  BagCondition condition = BagCondition::Whole;
};

class BagRecording;
struct Options;

/// Safe from any thread. Every ten minutes of simulated time are one bag; the newest dozen are kept.
class BagStore {
 public:
  BagStore(const RobotState& state, MapLibrary& library, const Options& options);

  std::vector<Bag> list(BagFolder folder) const;  // oldest first
  std::optional<Bag> find(BagFolder folder, std::string_view name) const;
  /// Stores the last seconds. Replaces a file with the same second and name.
  Bag record(std::string_view suffix, double duration_s, bool every_scan);

  void remove(BagFolder folder, const std::string& name);
  /// The bag being recorded stays.
  void removeAll(BagFolder folder);

  /// What is in a bag; the last few are kept.
  std::shared_ptr<const BagRecording> recordingOf(const Bag& bag);

 private:
  std::vector<Bag> bags() const;

  const RobotState& state_;
  MapLibrary& library_;
  const Options& options_;
  mutable std::mutex mutex_;
  std::set<std::string, std::less<>> removed_;  // bags
  std::vector<Bag> recordings_;
  Cache<BagSpan, std::shared_ptr<const BagRecording>> read_{4};
};

}  // namespace mapwright::simulator
