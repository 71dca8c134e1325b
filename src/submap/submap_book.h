// The submaps of the present SLAM session: what the robot lists, what is held, and where it lies.
// Pure state on the GUI thread. Source: submap-textures.md, "Geometry" and "Versions, cache and fetch rules".
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "geometry/pose.h"
#include "geometry/rect.h"
#include "map/problem.h"
#include "map/submap.h"
#include "raster/cell_texture.h"

namespace mapwright::submap {

/// One slice ready to draw. `texture` null = the robot sent no such slice, or it was corrupt.
struct Slice {
  std::shared_ptr<const raster::CellTexture> texture;
  geometry::Pose3 slice_pose;
  std::int32_t z_level = 0;
  std::string corrupt;  // why it cannot be drawn; empty when fine or simply absent
};

/// A submap decoded off the GUI thread, waiting to be committed.
struct DecodedSubmap {
  map::SubmapKey key;
  std::int32_t version = 0;  // the answer's own, or the key's when the answer said none
  std::vector<Slice> slices;
  std::size_t bytes = 0;
};

/// Everything known of one listed submap.
struct SubmapRow {
  map::SubmapEntry entry;  // the newest usable list entry
  bool pose_usable = false;
  std::string pose_problem;         // why not
  bool stale_texture = false;       // texture kept while a lower version was listed (see SubmapBook::apply)
  std::int32_t shown_version = -1;  // -1 = nothing held
  std::vector<Slice> slices;
  std::size_t texture_bytes = 0;
  bool visible = true;  // by the user's choice

  bool active() const { return !entry.is_frozen; }
  /// It has a place and a picture of this slice: what is counted as shown, wherever it is counted.
  bool drawable(int slice) const;
  /// Why some slice is not drawn; empty when all that came are fine.
  std::string corruptReason() const;
};

/// What a list or a commit changed.
struct BookChange {
  bool new_session = false;           // everything of before is gone
  bool set_changed = false;           // submaps were added or removed
  std::vector<map::SubmapId> placed;  // pose, texture or flags changed: draw again
  std::vector<map::SubmapId> removed;
  std::vector<map::SubmapId> restarted;  // version went back for good: forget what was fetched
  std::vector<map::Problem> problems;
  std::vector<map::Recovery> recoveries;  // what was wrong before and is well now
};

/// Where one slice lies.
struct Placement {
  std::shared_ptr<const raster::CellTexture> texture;
  geometry::Pose2 world_from_texture;
};

class SubmapBook {
 public:
  using Rows = std::map<map::SubmapId, SubmapRow>;

  /// Takes over a list. A pose that is not usable leaves the last good one; a duplicate counts once (its
  /// highest version, then the first); a version below the shown one keeps the newer picture until
  /// kBackwardLists lists in a row insist on it.
  BookChange apply(const map::SubmapList& list);
  static constexpr int kBackwardLists = 3;

  /// Puts a decoded submap on screen. Ignored (empty change) when it is of another session, no longer listed
  /// or older than what is shown.
  BookChange commit(DecodedSubmap decoded);

  void setVisible(map::SubmapId id, bool visible);

  const Rows& rows() const { return rows_; }
  const SubmapRow* find(map::SubmapId id) const;
  const std::string& uuid() const { return uuid_; }
  map::SlamState slamState() const { return slam_state_; }
  bool listReceived() const { return list_received_; }
  std::size_t textureBytes() const { return texture_bytes_; }

  /// Where slice `slice` of the submap is drawn; nullopt when it has no such slice, no texture or no usable
  /// pose.
  std::optional<Placement> placement(map::SubmapId id, int slice) const;
  /// World bounds of that slice, or a point at the submap's pose while nothing is held; empty without a
  /// usable pose.
  geometry::WorldRect bounds(map::SubmapId id, int slice) const;
  int maxSlices() const;

 private:
  std::string uuid_;
  map::SlamState slam_state_ = map::SlamState::Invalid;
  bool list_received_ = false;
  Rows rows_;
  std::map<map::SubmapId, int> backward_lists_;
  std::set<map::SubmapId> listed_twice_;
  bool rows_rejected_ = false;
  std::size_t texture_bytes_ = 0;
};

/// Coordinates beyond this are taken for garbage: no robot's map is 1000 km from its origin.
inline constexpr double kMaxCoordinateM = 1e6;

/// Unpacks and checks the slices of an answer. Pure and slow (milliseconds): for worker threads.
/// `corrupt` of a slice says what is wrong with it; the others are unharmed.
DecodedSubmap decode(const map::SubmapAnswer& answer);

}  // namespace mapwright::submap
