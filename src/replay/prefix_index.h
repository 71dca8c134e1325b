// What is known of a bag up to some time: the digests of the ranges that were read. Pure.
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
  /// Of the range that begins at `from`; one that was read again replaces what it was.
  void add(Tick from, Digest digest);
  /// Nothing is known of it any more.
  void forget(Tick from);
  void clear();
  const std::map<Tick, Digest>& digests() const { return digests_; }

  /// What is made of more than last messages (see replay/digest.h), after all ranges before `from`. Of the
  /// rest of the world nothing in it is right. What each range comes to is kept, so that asking again costs a
  /// copy. All ranges before `from` must be there, or come without asking in between.
  map::World historyBefore(Tick from) const;

  /// Every topic of the ranges before `from`; the last stamps.
  void addTopicsBefore(Tick from, std::map<std::string, double>& last_s) const;

  /// The last message of a slot before `from`: `find(slot, range, last)` for each slot that was ever heard of
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

  /// What the ranges until the end of one come to. A trail is long, and each range adds to it: only what it
  /// added is kept.
  struct Fold {
    std::shared_ptr<const map::World> besides;  // all but pose and trail; shared while it stays the same
    std::optional<geometry::Pose2> pose;
    double at_s = 0;
    std::vector<map::TrailPoint> trail;  // what came to it
    bool trail_begins = false;           // nothing of before is left of it
  };

  std::map<Tick, Digest> digests_;
  std::map<std::string, Ranges> topics_;  // where each was heard
  std::map<Slot, Ranges> slots_;
  mutable std::map<Tick, Fold> folds_;  // of the first ranges, without a gap between them
};

/// Applies the messages of `digest` that count besides the last ones, up to `at_s`.
void foldHistory(map::World& world, const Digest& digest, double at_s);

}  // namespace mapwright::replay
