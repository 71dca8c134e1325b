// Driving costs: the solids of the floor plan, inflated by the robot's size.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "simulator/floor_plan.h"
#include "simulator/png_writing.h"

namespace mapwright::simulator {

/// The position of a grid: `origin_m` is the world position of the lower-left cell's outer corner.
struct GridPlace {
  int width = 0, height = 0;  // cells
  double resolution_m = 0.05;
  Eigen::Vector2d origin_m{0, 0};
};

/// A square of `cells` around a position, on the lattice through the world's origin.
GridPlace squareAround(const Eigen::Vector2d& centre_m, int cells, double resolution_m);

/// 0 free, 254 in a solid, 253 where the robot's centre must not go, decreasing beyond. Top row first.
GrayPicture costsOf(const FloorPlan& plan, const std::vector<Solid>& extra, const GridPlace& place);

}  // namespace mapwright::simulator
