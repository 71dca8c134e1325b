// Changes the overlays of a map on a robot: looks at what it holds now, merges, sends all of it once, and
// looks again, whatever the robot answered and also where the answer is lost. The window and the commands
// save so.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <QString>

#include "overlays/overlay_merge.h"
#include "robot/overlay_store.h"

namespace mapwright::jobs {

/// What the robot holds after a change.
struct OverlaysHeld {
  overlays::OverlayDocument document, sent;
  bool as_sent = false;  // but for new ids
};

/// What is to become of the overlays.
struct OverlayOrder {
  map::MapKey map;
  overlays::OverlayDocument mine;
  /// What `mine` was made from; nullopt: `mine` replaces everything.
  std::optional<overlays::OverlayDocument> base;
  bool send = true;           // false: only looks and merges
  bool may_empty = true;      // false: nothing is sent that deletes more features than it keeps
  std::string only_uid = {};  // not empty: nothing is sent to a map with another uid
  /// What the robot holds, if that is known: it is not asked before, and the reply may come at once.
  std::optional<robot::OverlayText> held = {};
  /// Does the work on another thread, then on this one what it returns, as long as the store lives; null: all
  /// at once.
  using Elsewhere = std::function<void(std::function<std::function<void()>()> work)>;
  Elsewhere elsewhere = {};
  /// Gets what the robot turns out to hold, each time that it was asked. `saved`: with the change. `read`:
  /// what is known of that text already; null: nothing. May be empty.
  std::function<void(const robot::OverlayText&, bool saved, const OverlaysHeld* read)> seen = {};
};

struct OverlayOutcome {
  overlays::OverlayMerge merge;                  // with what the robot held
  std::vector<overlays::OverlayChange> changes;  // of that, to what was merged
  /// Nothing was sent: there are conflicts, nothing to change, or it was not wanted.
  bool sent = false;
  /// How many features of the robot go and stay; `held_back`: that is why nothing was sent.
  std::size_t deletes = 0, keeps = 0;
  bool held_back = false;
  robot::OverlayText before, held;  // what the robot held, and holds as far as known, to the byte

  // After sending:
  /// What differs between what was sent and what the robot holds now.
  std::vector<overlays::OverlayChange> differs;
  enum class Between {
    None,  // nobody else changed them between the look and the request
    Somebody,
    Unknown,  // the robot tells no version, or does not count
  };
  Between between = Between::None;
  Fault unreadable = {};  // why what it holds now cannot be read

  /// It holds what was sent, and nobody came between.
  bool certain() const { return !sent || (differs.empty() && between == Between::None && !unreadable.any()); }
  /// Whether it holds what was wanted.
  map::Applied applied() const;
};

/// Why it is not certain, in words; empty: it is.
QString doubtOf(const OverlayOutcome& outcome);

/// What the robot holds otherwise than it was sent, besides the ids that it gives to features without one.
std::vector<overlays::OverlayChange> otherwiseHeld(const overlays::OverlayDocument& sent,
                                                   const overlays::OverlayDocument& held);

/// The error of an unreadable answer of the robot is MalformedAnswer; `applied` says whether the change may
/// have been made all the same. No result if the store is destroyed first.
robot::Call changeOverlays(robot::OverlayStore& store, OverlayOrder order,
                           robot::OutcomeTo<OverlayOutcome> reply);

}  // namespace mapwright::jobs
