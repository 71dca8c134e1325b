// The counters of all submaps, updated one submap at a time. Pure state.
#pragma once

#include <map>
#include <unordered_map>
#include <vector>

#include <QtGlobal>

#include "geometry/rect.h"
#include "map/submap.h"

namespace mapwright::session {

/// The state of one submap, for a row of the inspector.
enum class SubmapStatus {
  OnScreen,  // the listed version is loaded and drawn
  Hidden,    // the same, but hidden by the user
  Updating,  // an older version is on screen, the listed one is queued or being fetched
  Queued,
  Fetching,
  NoSlice,   // loaded, but without the chosen slice
  Missing,   // 404
  Waiting,   // failed; will be tried again
  Corrupt,   // came, but cannot be drawn
  Unplaced,  // no usable pose
};

/// Counters of all listed submaps. held + pending + without_slice + missing + failed + corrupt == listed.
struct SubmapCounts {
  bool list_received = false;
  int listed = 0;
  int held = 0;     // have a drawable chosen slice (also an older version while Updating)
  int shown = 0;    // of these, the ones that are not hidden
  int pending = 0;  // nothing loaded yet: queued, being fetched or being decoded
  int without_slice = 0;
  int missing = 0;
  int failed = 0;    // waiting for a retry, nothing loaded
  int corrupt = 0;   // corrupt chosen slice, or no valid pose
  int hidden = 0;    // by the user, loaded or not
  int updating = 0;  // a newer version than the one on screen is on its way
  int trajectories = 0;
  int fetching = 0, queued = 0;  // fetch work
  qint64 texture_bytes = 0;
  quint64 fetches = 0;        // submaps and pictures transferred over the network
  quint64 cache_hits = 0;     // those from the disk cache
  quint64 bytes_fetched = 0;  // of the transferred bodies
  bool operator==(const SubmapCounts&) const = default;
};

/// Rows that may look different since the last signal.
struct TouchedRows {
  bool all = false;                // the session is new, or everything looks different
  std::vector<map::SubmapId> ids;  // otherwise these, ascending: listed ones, and removed ones
};

/// The contribution of one submap to the counters.
struct SubmapStanding {
  SubmapStatus status = SubmapStatus::Queued;
  bool drawable = false;
  bool visible = true;
  geometry::WorldRect bounds;  // where it is drawn, or the point of its pose; empty without a valid one
};

/// Counters are free to read, and a change costs as much as one submap.
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
  void add(const SubmapStanding& standing, int by);

  std::unordered_map<map::SubmapId, SubmapStanding> standings_;
  std::map<std::int32_t, int> by_trajectory_;
  SubmapCounts counts_;
};

}  // namespace mapwright::session
