// What becomes of things that were placed by hand on an old map of a site, on a new one. Pure; not for the
// GUI thread: large maps take seconds. Why: docs/tasks/new-map.md.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "geometry/pose.h"
#include "placing/ground.h"
#include "render/sample_grid.h"

namespace mapwright::carry {

enum class Verdict {
  Kept,          // moved by the transform alone
  Adjusted,      // moved a little further, to where the walls around it are now
  InObstacle,    // a wall is there now, or so close that the robot does not fit
  Outside,       // the new map knows nothing there
  Unreachable,   // cut off from the others
  NotSupported,  // no wall around it agrees
};
inline constexpr int kVerdicts = 6;
/// For scripts, never changes: "in_obstacle".
const char* nameOf(Verdict verdict);
/// It may be carried over without a look.
inline bool sound(Verdict verdict) { return verdict == Verdict::Kept || verdict == Verdict::Adjusted; }

/// Beside a wall in the old map already: a wall that is this much closer counts.
inline constexpr double kCloser_m = 0.1;
/// What a whole map has at a place; waits for its cells.
placing::Ground groundOf(const render::PlacedGrid& map);

struct Spot {
  Eigen::Vector2d position_m{0, 0};
  std::optional<double> yaw_rad = {};
  bool operator==(const Spot&) const = default;
};

struct Carried {
  geometry::Pose2 transform;  // for this thing
  Spot spot;                  // on the new map
  Verdict verdict = Verdict::Kept;
  /// Of the walls of both maps around it, whichever are off more, before an adjustment; nullopt: there are
  /// none.
  std::optional<double> local_residual_m = {};
};

struct CarryOptions {
  double radius_m = 0.3;  // of the robot
  bool adjust = false;
};

/// Two maps and where the old one lies on the new one.
class Site {
 public:
  Site(const render::PlacedGrid& old_map, const render::PlacedGrid& new_map,
       const geometry::Pose2& transform);
  ~Site();

  /// Where robots stop, in the order of `old_spots`. Unreachable: cut off from most of the others by walls.
  std::vector<Carried> carried(const std::vector<Spot>& old_spots, const CarryOptions& options) const;
  /// One of them, but for Unreachable.
  Carried carriedStop(const Spot& old_spot, const CarryOptions& options) const;
  /// One thing whose outline is not driven to: only Kept, Adjusted, Outside and NotSupported. `old_points`
  /// are its corners, at least one; `spot` is their mean.
  Carried carriedShape(const std::vector<Eigen::Vector2d>& old_points, bool adjust) const;

 private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

}  // namespace mapwright::carry
