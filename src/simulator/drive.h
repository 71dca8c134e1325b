// The robot's route: a polyline with rounded corners, parameterised by length.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "geometry/pose.h"

namespace mapwright::simulator {

/// Immutable. Metres in the world; headings follow the route and turn smoothly.
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
