// Cartographer submaps as plain values: their ids, their poses, and a robot's answer to a request for one.
// Source: docs/protocols/cartographer-submaps.md, "Messages", "Versions, caching and fetching",
// docs/protocols/autoxing.md, "Live topics".
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "geometry/pose.h"
#include "map/problem.h"

namespace mapwright::map {

/// A submap within one SLAM session. Submaps are painted in ascending order.
struct SubmapId {
  std::int32_t trajectory = 0;
  std::int32_t index = 0;
  auto operator<=>(const SubmapId&) const = default;
};

/// "12-3": the displayed name of a submap.
std::string toText(SubmapId id);
/// The submap as the subject of a problem, in any version.
Subject subjectOf(SubmapId id);

/// Identifies the content. The pose is not part of it.
struct SubmapKey {
  std::string uuid;
  SubmapId id;
  std::int32_t version = 0;
  auto operator<=>(const SubmapKey&) const = default;
};

/// One row of a /submap_list. `pose` is as received and may be invalid (see geometry::toIsometry).
struct SubmapEntry {
  SubmapId id;
  std::int32_t version = 0;
  geometry::Pose3 pose;
  bool is_frozen = false;
  bool is_incremental = false;
  bool is_nearby = false;
  bool operator==(const SubmapEntry&) const = default;
};

enum class SlamState { Invalid, Slam, Positioning };

/// A whole /submap_list message. `rejected`: why rows could not be read.
struct SubmapList {
  SlamState slam_state = SlamState::Invalid;
  std::string uuid;
  std::vector<SubmapEntry> entries;
  std::vector<Fault> rejected;
  bool operator==(const SubmapList&) const = default;
};

/// One slice of a submap as received: nothing in it is checked yet.
struct RawSlice {
  std::int32_t cell_format = 0;  // 0 LOG_ODDS, 1 TSDF_DELTA, 2 INTENSITY
  std::string cells;             // any container, any layout
  std::int32_t width = 0;        // columns
  std::int32_t height = 0;       // rows
  double resolution_m = 0;       // metres per cell
  std::int32_t z_level = 0;
  geometry::Pose3 slice_pose;  // identity if the robot sent none
};

/// How a query for one submap ended.
struct SubmapAnswer {
  enum class Outcome {
    Ok,         // `slices` is what the robot has
    NotFound,   // 404 or NOT_FOUND: remembered for this key
    WrongUuid,  // UUID_MISMATCH: wait for the next list
    Failed,     // anything else, including unreadable answers: wait, then try again
    Cancelled,  // nobody wants it any more
  };
  SubmapKey key;  // as it was asked
  Outcome outcome = Outcome::Failed;
  Fault reason;                  // none when Ok
  std::int32_t version = 0;      // as stated in the answer; 0 = not stated
  std::vector<RawSlice> slices;  // by slice id
  std::size_t bytes = 0;         // payload size
  bool from_cache = false;       // nothing was transferred: disk cache, or 304
  FailureKind failure = FailureKind::None;
};

}  // namespace mapwright::map

namespace std {
template <>
struct hash<mapwright::map::SubmapId> {
  std::size_t operator()(mapwright::map::SubmapId id) const noexcept {
    return std::hash<std::uint64_t>{}((std::uint64_t(std::uint32_t(id.trajectory)) << 32) |
                                      std::uint32_t(id.index));
  }
};
}  // namespace std
