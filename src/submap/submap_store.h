// The submaps of the present SLAM session: the robot's list, the loaded pictures, and their positions. Pure
// state on the GUI thread. Source: docs/protocols/cartographer-submaps.md, "Geometry", "Versions, caching and
// fetching".
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
#include "submap/compare_lists.h"

namespace mapwright::cells {
class CellTexture;
}

namespace mapwright::submap {

/// One slice ready to draw. `texture` null = the robot sent no such slice, or it was corrupt.
struct Slice {
  std::shared_ptr<const cells::CellTexture> texture;
  geometry::Pose3 slice_pose;
  std::int32_t z_level = 0;
  Fault corrupt;  // why it cannot be drawn; none if fine or absent
};

/// A submap decoded off the GUI thread, ready to be committed.
struct DecodedSubmap {
  map::SubmapKey key;
  std::int32_t version = 0;  // the answer's own, or the key's if it has none
  std::vector<Slice> slices;
  std::size_t bytes = 0;
};

/// Everything known about one listed submap.
struct SubmapRow {
  map::SubmapEntry entry;  // the newest valid list entry
  bool pose_usable = false;
  FaultCode pose_problem;      // why not
  bool stale_texture = false;  // a lower version was listed, and the texture is kept (see SubmapStore::apply)
  std::int32_t shown_version = -1;  // -1 = nothing loaded
  std::vector<Slice> slices;
  std::size_t texture_bytes = 0;
  bool visible = true;  // the user's choice

  bool active() const { return !entry.is_frozen; }
  /// It has a position and a picture of this slice: the definition of "shown" for all counters.
  bool drawable(int slice) const;
  /// Why slices are not drawn; empty if all received ones are fine.
  std::vector<Fault> corruptSlices() const;
};

/// What a list or a commit changed.
struct SubmapChange {
  bool new_session = false;           // everything before was dropped
  bool set_changed = false;           // submaps were added or removed
  std::vector<map::SubmapId> listed;  // new, or changed in the list
  std::vector<map::SubmapId> placed;  // pose, texture or flags changed: redraw
  std::vector<map::SubmapId> removed;
  std::vector<map::SubmapId> restarted;  // version went back permanently: drop what was fetched
  std::vector<map::Problem> problems;
  std::vector<map::Recovery> recoveries;  // former problems that are resolved now
};

/// The pose of one slice.
struct Placement {
  std::shared_ptr<const cells::CellTexture> texture;
  geometry::Pose2 world_from_texture;
};

class SubmapStore {
 public:
  using Rows = std::map<map::SubmapId, SubmapRow>;

  /// Applies the differences to the previous list. An invalid pose keeps the last valid one; a version below
  /// the shown one keeps the newer picture until kBackwardLists lists in a row repeat it. The cost depends on
  /// the changes.
  SubmapChange apply(const ListDifference& list);
  /// The same with a whole list.
  SubmapChange apply(const map::SubmapList& list);
  static constexpr int kBackwardLists = 3;
  /// As before the first list.
  SubmapChange clear();
  /// The base for comparing the next list.
  const ListedBefore& listedBefore() const { return listed_before_; }

  /// Shows a decoded submap. Ignored (empty change) if it is of another session, no longer listed or older
  /// than what is shown.
  SubmapChange commit(DecodedSubmap decoded);

  /// The picture is lost; the position stays. Empty if there was none.
  SubmapChange lose(map::SubmapId id);

  void setVisible(map::SubmapId id, bool visible);

  const Rows& rows() const { return rows_; }
  const SubmapRow* find(map::SubmapId id) const;
  const std::string& uuid() const { return uuid_; }
  map::SlamState slamState() const { return slam_state_; }
  bool listReceived() const { return list_received_; }
  int frozenCount() const { return frozen_; }

  /// The pose at which slice `slice` of the submap is drawn; nullopt if it has no such slice, no texture or
  /// no valid pose.
  std::optional<Placement> placement(map::SubmapId id, int slice) const;
  /// World bounds of that slice, or a point at the submap's pose while nothing is loaded; empty without a
  /// valid pose.
  geometry::WorldRect bounds(map::SubmapId id, int slice) const;
  int maxSlices() const { return with_slices_.empty() ? 0 : int(with_slices_.rbegin()->first); }

 private:
  void applyListed(const ListedEntry& listed, SubmapChange& change);
  /// Compares the listed version with the one on screen.
  void weighVersion(map::SubmapId id, SubmapRow& row, SubmapChange& change);
  void forget(Rows::iterator at);
  void countSlices(std::size_t before, std::size_t now);

  std::string uuid_;
  map::SlamState slam_state_ = map::SlamState::Invalid;
  bool list_received_ = false;
  Rows rows_;
  ListedBefore listed_before_;
  /// On screen with a later version than listed: in how many lists in a row.
  std::map<map::SubmapId, int> ahead_;
  std::set<map::SubmapId> listed_twice_;
  bool rows_rejected_ = false;
  int frozen_ = 0;
  std::map<std::size_t, int> with_slices_;  // how many have this many slices
};

/// Unpacks and checks the slices of an answer. Pure and slow (milliseconds): for worker threads. `corrupt`
/// says what is wrong with a slice; the others are unaffected.
DecodedSubmap decode(const map::SubmapAnswer& answer);

}  // namespace mapwright::submap
