// The states of a session's submaps, and counters.
#pragma once

#include <vector>

#include <QtGlobal>

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

}  // namespace mapwright::session
