// The points hit by one turn of the lidar.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "geometry/pose.h"
#include "simulator/floor_plan.h"

namespace mapwright::simulator {

struct LidarPoint {
  Eigen::Vector2d at_m{0, 0};  // world
  float z_m = 0;
  std::uint8_t intensity = 0;
};

/// Exactly `points` of them, in the order of their angle within each turn; none if nothing is in range. A few
/// hundred rays find the walls, further turns repeat them at other heights with other noise: cheap for any
/// number. Pure.
std::vector<LidarPoint> scanFrom(const FloorPlan& plan, const geometry::Pose2& pose, int points,
                                 std::uint64_t seed);

/// Metres to the nearest solid on `rays` rays, counter-clockwise from the heading of `pose`; infinity if
/// nothing is in range. Pure.
std::vector<double> rangesFrom(const FloorPlan& plan, const geometry::Pose2& pose, int rays,
                               std::uint64_t seed);

/// The range of the lidar, metres.
constexpr double kLidarRangeM = 25;

}  // namespace mapwright::simulator
