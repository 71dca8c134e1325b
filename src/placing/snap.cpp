#include "placing/snap.h"

#include <cmath>
#include <limits>

#include "geometry/pose.h"

namespace mapwright::placing {
namespace {

constexpr double kAlongAxis = 0.99;       // cosine for a wall's normal parallel to an axis
constexpr int kMostSteps = 4;             // iterations for the distance from a curved wall
constexpr double kWallWithinCells = 0.3;  // final precision
constexpr double kLongLineM = 1e5;

struct AxisCatch {
  double value;
  Caught what;
  double off;              // how far it is
  Eigen::Vector2d from_m;  // what it belongs to
};

/// The nearest line perpendicular to `axis` (0: lines of constant x).
std::optional<AxisCatch> lineNear(const Eigen::Vector2d& at_m, int axis, const SnapRules& rules,
                                  const SnapScene& scene) {
  std::optional<AxisCatch> best;
  if (rules.waypoints && scene.others) {
    geometry::WorldRect strip = scene.seen;
    (axis == 0 ? strip.min_x : strip.min_y) = at_m[axis] - scene.reach_m;
    (axis == 0 ? strip.max_x : strip.max_y) = at_m[axis] + scene.reach_m;
    double along = std::numeric_limits<double>::infinity();
    scene.others(strip, [&](const Eigen::Vector2d& other) {
      const double off = std::abs(other[axis] - at_m[axis]), away = (other - at_m).norm();
      if (off > scene.reach_m || (best && (off > best->off || (off == best->off && away >= along)))) return;
      best = AxisCatch{other[axis], axis == 0 ? Caught::LineX : Caught::LineY, off, other};
      along = away;
    });
  }
  if (rules.grid && rules.grid_m > 0) {
    const double value = std::round(at_m[axis] / rules.grid_m) * rules.grid_m,
                 off = std::abs(value - at_m[axis]);
    if (off <= scene.reach_m && (!best || off < best->off))
      best = AxisCatch{value, axis == 0 ? Caught::GridX : Caught::GridY, off, at_m};
  }
  return best;
}

struct WallCatch {
  Eigen::Vector2d at_m, wall_m;
};

std::optional<WallCatch> atWall(const Eigen::Vector2d& free_m, const SnapRules& rules,
                                const SnapScene& scene) {
  Ground& ground = *scene.ground;
  const double exact = ground.map().reference.resolution_m * kWallWithinCells;
  Eigen::Vector2d at = free_m;
  for (int step = 0; step < kMostSteps; ++step) {
    const auto wall = ground.nearestWall(at, rules.wall_m + scene.reach_m);
    if (!wall || !(wall->distance_m > 0)) return std::nullopt;
    if (step > 0 && std::abs(wall->distance_m - rules.wall_m) <= exact) return WallCatch{at, wall->at_m};
    const Eigen::Vector2d away = (at - wall->at_m) / wall->distance_m;
    at = wall->at_m + away * rules.wall_m;
    if ((at - free_m).norm() > scene.reach_m) return std::nullopt;
  }
  return std::nullopt;
}

Guide guideOf(const AxisCatch& caught, const Eigen::Vector2d& at_m, int axis, const SnapScene& scene) {
  Guide guide{caught.what, caught.from_m, at_m};
  if (caught.what == Caught::GridX || caught.what == Caught::GridY) {
    // Across all that is seen.
    const int other = 1 - axis;
    guide.from_m[axis] = guide.to_m[axis] = caught.value;
    guide.from_m[other] = std::max(other == 0 ? scene.seen.min_x : scene.seen.min_y, -kLongLineM);
    guide.to_m[other] = std::min(other == 0 ? scene.seen.max_x : scene.seen.max_y, kLongLineM);
  }
  return guide;
}

}  // namespace

SnappedPlace snapped(const Eigen::Vector2d& free_m, const SnapRules& rules, const SnapScene& scene) {
  SnappedPlace place{free_m, {}};
  if (!free_m.allFinite()) return place;
  if (rules.waypoints && scene.others) {
    double nearest = scene.reach_m;
    std::optional<Eigen::Vector2d> point;
    scene.others(geometry::WorldRect{free_m.x(), free_m.y(), free_m.x(), free_m.y()}.grown(scene.reach_m),
                 [&](const Eigen::Vector2d& other) {
                   const double away = (other - free_m).norm();
                   if (away > nearest || (point && away == nearest)) return;
                   nearest = away;
                   point = other;
                 });
    if (point) return {*point, {{Caught::Point, *point, *point}}};
  }
  bool taken[2] = {false, false};
  if (rules.walls && rules.wall_m > 0 && scene.ground && scene.ground->there()) {
    if (const auto wall = atWall(free_m, rules, scene)) {
      place.at_m = wall->at_m;
      place.guides.push_back({Caught::Wall, wall->wall_m, wall->at_m});
      const Eigen::Vector2d normal = (wall->at_m - wall->wall_m).normalized();
      taken[0] = std::abs(normal.y()) < kAlongAxis;
      taken[1] = std::abs(normal.x()) < kAlongAxis;
    }
  }
  for (const int axis : {0, 1}) {
    if (taken[axis]) continue;
    const auto line = lineNear(place.at_m, axis, rules, scene);
    if (!line) continue;
    place.at_m[axis] = line->value;
    place.guides.push_back(guideOf(*line, place.at_m, axis, scene));
  }
  // The second line has moved the end of the first guide, and the base point on the wall moves along.
  for (Guide& guide : place.guides) {
    if (guide.what == Caught::LineX || guide.what == Caught::LineY) guide.to_m = place.at_m;
    if (guide.what == Caught::Wall) {
      guide.from_m += place.at_m - guide.to_m;
      guide.to_m = place.at_m;
    }
  }
  return place;
}

Eigen::Vector2d onGrid(const Eigen::Vector2d& at_m, double step_m) {
  return {std::round(at_m.x() / step_m) * step_m, std::round(at_m.y() / step_m) * step_m};
}

double snappedHeading(double yaw_rad, double reach_rad) {
  const double step = geometry::radiansFromDegrees(kHeadingStepDeg);
  const double to = std::round(yaw_rad / step) * step;
  return std::abs(to - yaw_rad) <= reach_rad ? geometry::normalizeAngle(to) : yaw_rad;
}

}  // namespace mapwright::placing
