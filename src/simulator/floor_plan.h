// The obstacles in the building, solid shapes on the floor, and the robot's route among them; in world
// metres.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "geometry/pose.h"

namespace mapwright::simulator {

/// A box (centre, half extents, rotated by yaw) or, if `round`, a disc of radius half.x().
struct Solid {
  Eigen::Vector2d centre{0, 0};
  Eigen::Vector2d half{0, 0};
  double yaw_rad = 0;
  bool round = false;
  bool movable = false;  // furniture that is removed from the robot's route; walls are not

  /// Radius of the circle around `centre` that contains the shape.
  double reach() const { return round ? half.x() : half.norm(); }
  /// Half the size of the upright rectangle around it.
  Eigen::Vector2d extent() const;
  /// Metres from `point` to the shape; 0 or less inside it.
  double distanceTo(const Eigen::Vector2d& point) const;
};

/// All solids of a scene, with a spatial index. Immutable, safe to read from any thread.
class FloorPlan {
 public:
  FloorPlan() = default;
  explicit FloorPlan(std::vector<Solid> solids);

  const std::vector<Solid>& solids() const { return solids_; }
  /// Indices of the solids that may touch the rectangle, each once, ascending.
  std::vector<std::uint32_t> near(const Eigen::Vector2d& low, const Eigen::Vector2d& high) const;

 private:
  struct Span {
    int x0, y0, x1, y1;
  };
  Span cellsOf(const Eigen::Vector2d& low, const Eigen::Vector2d& high) const;

  std::vector<Solid> solids_;
  Eigen::Vector2d origin_{0, 0};
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::uint32_t> starts_;   // per grid cell, into members_
  std::vector<std::uint32_t> members_;  // solid indices
};

/// The robot's route: a polyline with rounded corners, parameterised by length. Immutable. Metres in the
/// world; headings follow the route and turn smoothly.
class Drive {
 public:
  Drive() = default;
  /// Through `waypoints` in order; `closed` returns to the first one.
  Drive(const std::vector<Eigen::Vector2d>& waypoints, bool closed);

  double length_m() const { return along_.empty() ? 0 : along_.back(); }
  bool closed() const { return closed_; }
  /// The pose after `s` metres. Wraps on a closed route, stops at the ends of an open one.
  geometry::Pose2 at(double s) const;

 private:
  Eigen::Vector2d pointAt(double s) const;

  std::vector<Eigen::Vector2d> points_;
  std::vector<double> along_;  // length up to each point
  bool closed_ = false;
};

}  // namespace mapwright::simulator
