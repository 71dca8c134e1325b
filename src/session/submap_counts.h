// How the submaps of a session stand, in words and in numbers.
#pragma once

#include <vector>

#include <QtGlobal>

#include "map/submap.h"

namespace mapwright::session {

/// How one submap stands, for a row of the inspector.
enum class SubmapStatus {
  OnScreen,  // the listed version is held and drawn
  Hidden,    // the same, but the user has hidden it
  Updating,  // an older version is on screen, the listed one is queued or being fetched
  Queued,
  Fetching,
  NoSlice,   // held, but it has no slice of the chosen number
  Missing,   // 404
  Waiting,   // failed; will be tried again
  Corrupt,   // came, but cannot be drawn
  Unplaced,  // no usable pose
};

/// Counters over all listed submaps. held + pending + without_slice + missing + failed + corrupt == listed.
struct SubmapCounts {
  bool list_received = false;
  int listed = 0;
  int held = 0;     // have a drawable chosen slice (also an older version while Updating)
  int shown = 0;    // those of them that are not hidden
  int pending = 0;  // nothing held yet: queued, being fetched or being decoded
  int without_slice = 0;
  int missing = 0;
  int failed = 0;    // waiting for another try, nothing held
  int corrupt = 0;   // corrupt chosen slice, or no usable pose
  int hidden = 0;    // by the user's choice, whether held or not
  int updating = 0;  // a newer version than the one on screen is on its way
  int trajectories = 0;
  int fetching = 0, queued = 0;  // fetch work
  qint64 texture_bytes = 0;
  quint64 fetches = 0;        // submaps and pictures whose body travelled over the network
  quint64 cache_hits = 0;     // those whose body was on disk
  quint64 bytes_fetched = 0;  // of the bodies that travelled
  bool operator==(const SubmapCounts&) const = default;
};

/// Whose rows may look different than at the last time that was told.
struct TouchedRows {
  bool all = false;                // the session is new, or everything is seen otherwise
  std::vector<map::SubmapId> ids;  // else these, ascending: listed ones, and such as are not any more
};

}  // namespace mapwright::session
