// What is known of a bag up to a time: the digests of the ranges read so far. Pure.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "map/world.h"
#include "replay/chunks.h"
#include "replay/digest.h"

namespace mapwright::replay {

class PrefixIndex {
 public:
  /// For the range that begins at `from`; replaces an earlier one.
  void add(Tick from, Digest digest);
  /// Removes a range.
  void forget(Tick from);
  void clear();
  const std::map<Tick, Digest>& digests() const { return digests_; }

  /// The state that depends on more than the last messages (see replay/digest.h), after all ranges before
  /// `from`. Nothing else in the result is valid. The result for each range is kept, so that repeating costs
  /// a copy. All ranges before `from` must be there, or be added before the next call.
  map::World historyBefore(Tick from) const;

  /// Every topic in the ranges before `from` with its last stamp.
  void addTopicsBefore(Tick from, std::map<std::string, double>& last_s) const;

  /// The last message of a slot before `from`: calls `find(slot, range, last)` for each slot that occurs
  /// there.
  template <typename Find>
  void forLastBefore(Tick from, Find find) const {
    for (const auto& [slot, ranges] : slots_) {
      if (const std::optional<Tick> range = lastOf(ranges, from))
        find(slot, *range, digests_.at(*range).last.at(slot));
    }
  }

 private:
  using Ranges = std::vector<Tick>;  // sorted
  static std::optional<Tick> lastOf(const Ranges& ranges, Tick before);
  void share(const Slot& slot, Digest::Last& last, const Ranges& ranges, Tick from) const;
  void unfile(Tick from, const Digest& digest);
  void foldUntil(Tick from) const;

  /// The state after a range. A trail is long, and each range adds to it: only the addition is stored.
  struct Fold {
    std::shared_ptr<const map::World> besides;  // everything except pose and trail; shared while unchanged
    std::optional<geometry::Pose2> pose;
    double at_s = 0;
    std::vector<map::TrailPoint> trail;  // what came to it
    bool trail_begins = false;           // the earlier trail was cleared
  };

  std::map<Tick, Digest> digests_;
  std::map<std::string, Ranges> topics_;  // where each was heard
  std::map<Slot, Ranges> slots_;
  mutable std::map<Tick, Fold> folds_;  // for the first ranges, without a gap
};

/// Applies the messages of `digest` that count besides the last ones, up to `at_s`.
void foldHistory(map::World& world, const Digest& digest, double at_s);

}  // namespace mapwright::replay
