// What a lidar sees: the points that one turn hits, and a drive past solids as a submap's probability grid.
// Axes and cell values: docs/protocols/cartographer-submaps.md, "Geometry", "Containers and cell layouts".
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "geometry/pose.h"
#include "simulator/floor_plan.h"

namespace mapwright::simulator {

/// Cells in texture order: row v runs along -x, column u along -y of the slice frame.
struct ScanGrid {
  int width = 0;   // columns
  int height = 0;  // rows
  double resolution_m = 0.05;
  geometry::Pose2 world_from_slice;  // the slice frame: its origin is the corner of cell (0, 0)
  std::vector<std::uint8_t> cells;   // 0 unknown; 1 certainly free ... 128 even ... 255 certainly occupied
};

struct ScanSettings {
  double resolution_m = 0.05;
  double range_m = 11.5;
  int rays = 240;          // per scan
  std::uint64_t seed = 0;  // of the sensor's noise
};

/// One place that the robot scanned from. `number` makes its noise its own, whichever submap it goes into.
struct ScanPlace {
  geometry::Pose2 pose;
  std::uint64_t number = 0;
};

/// Casts the rays of all scans and crops to what was seen; at least one cell. `yaw_rad` is the slice frame's
/// heading in the world, `anchor` the point its lattice goes through, so that versions of a submap share
/// their lattice. `extra` are solids besides the plan's.
ScanGrid scanGrid(const FloorPlan& plan, const std::vector<Solid>& extra, const std::vector<ScanPlace>& scans,
                  const Eigen::Vector2d& anchor, double yaw_rad, const ScanSettings& settings);

/// Around the places of some scans.
Eigen::AlignedBox2d boundsOf(const std::vector<ScanPlace>& scans);

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
