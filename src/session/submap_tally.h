// The counters over all submaps, kept up to date one submap at a time. Pure state.
#pragma once

#include <cstddef>
#include <map>
#include <unordered_map>
#include <vector>

#include "geometry/rect_union.h"
#include "session/submap_counts.h"

namespace mapwright::session {

/// What one submap adds to the counters.
struct SubmapStanding {
  SubmapStatus status = SubmapStatus::Queued;
  bool drawable = false;
  bool visible = true;
  geometry::WorldRect bounds;  // where it is drawn, or the point of its pose; empty without a usable one
};

/// Costs nothing to ask, and one submap's worth to change.
class SubmapTally {
 public:
  void set(map::SubmapId id, const SubmapStanding& standing);
  void remove(map::SubmapId id);
  void clear();

  /// Of the submaps alone: nothing of fetches and bytes.
  const SubmapCounts& counts() const { return counts_; }
  /// Around everything that is drawn and visible; while there is nothing, around the visible poses.
  geometry::WorldRect contentBounds() const;

 private:
  struct Entry {
    SubmapStanding standing;
    std::size_t place = 0;  // in the unions
  };
  void add(const SubmapStanding& standing, int by);

  std::unordered_map<map::SubmapId, Entry> entries_;
  std::vector<std::size_t> free_places_;
  std::map<std::int32_t, int> by_trajectory_;
  geometry::RectUnion drawn_, listed_;
  SubmapCounts counts_;
};

}  // namespace mapwright::session
