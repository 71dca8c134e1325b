// Lays one map over another by pairs of points. Pure functions; world metres, radians counter-clockwise.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "geometry/pose.h"

namespace mapwright::placing {

/// The same place twice: on the map that is laid, in its own coordinates, and where that is in the world.
struct PointPair {
  Eigen::Vector2d on_map_m{0, 0};
  Eigen::Vector2d in_world_m{0, 0};
  bool operator==(const PointPair&) const = default;
};

/// The rigid pose (no scale, no mirror image) with the least sum of squared residuals. One pair moves and
/// leaves the heading of `before`; none leaves all of it. Pairs that are all at one place leave the heading,
/// too.
geometry::Pose2 alignedBy(const std::vector<PointPair>& pairs, const geometry::Pose2& before);
/// How far each pair is off, metres.
std::vector<double> residualsOf(const std::vector<PointPair>& pairs, const geometry::Pose2& world_from_map);
/// The root of their mean square; 0 for none.
double rootMeanSquare(const std::vector<double>& residuals);

}  // namespace mapwright::placing
