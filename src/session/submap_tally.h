// The counters of all submaps, updated one submap at a time. Pure state.
#pragma once

#include <cstddef>
#include <map>
#include <unordered_map>
#include <vector>

#include "geometry/rect_union.h"
#include "session/submap_counts.h"

namespace mapwright::session {

/// The contribution of one submap to the counters.
struct SubmapStanding {
  SubmapStatus status = SubmapStatus::Queued;
  bool drawable = false;
  bool visible = true;
  geometry::WorldRect bounds;  // where it is drawn, or the point of its pose; empty without a valid one
};

/// Reading is free, and a change costs as much as one submap.
class SubmapTally {
 public:
  void set(map::SubmapId id, const SubmapStanding& standing);
  void remove(map::SubmapId id);
  void clear();

  /// Only submaps: without fetches and bytes.
  const SubmapCounts& counts() const { return counts_; }
  /// Bounds of everything drawn and visible; if there is nothing, of the visible poses.
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
