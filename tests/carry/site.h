// A hall with rooms, mapped twice; the second time with other coordinates.
#pragma once

#include "../align/buildings.h"
#include "carry/carried.h"
#include "grids/grid_pyramid.h"

namespace mapwright::testing {

inline render::PlacedGrid gridOf(const Plan& plan) {
  const auto builder =
      grids::buildGrid(plan.width, plan.height, grids::CellCode::Occupancy, grids::Reduction::OccupiedWins);
  for (int row = plan.height - 1; row >= 0; --row) {
    std::vector<std::uint8_t> cells;
    for (int column = 0; column < plan.width; ++column) {
      const Ground ground = plan.at(column, row);
      cells.push_back(ground == Ground::Wall ? 100 : ground == Ground::Free ? 0 : grids::kUnknownOccupancy);
    }
    builder->pushRow(cells);
  }
  builder->finish();
  return {builder->pyramid(),
          {plan.width, plan.height, plan.resolution_m, {plan.corner_m.x(), plan.corner_m.y(), 0}}};
}

/// 20 m x 10 m: a large room on the left, a small one on the right with a door between, unknown around.
inline Plan hall() {
  Plan plan;
  plan.width = 440;
  plan.height = 240;
  plan.resolution_m = 0.05;
  plan.corner_m = {-1, -1};
  plan.cells.assign(std::size_t(plan.width) * std::size_t(plan.height), Ground::Unknown);
  fill(plan, 20, 20, 419, 219, Ground::Wall);
  fill(plan, 22, 22, 417, 217, Ground::Free);
  fill(plan, 300, 22, 301, 217, Ground::Wall);
  fill(plan, 300, 100, 301, 125, Ground::Free);  // the door, at x 14, y 4 to 5.3
  return plan;
}

/// A wall around the rectangle, world metres.
inline void box(Plan& plan, double left, double low, double right, double high,
                Ground ground = Ground::Wall) {
  const auto cell = [&](double metres, double corner) { return int(std::floor((metres - corner) / 0.05)); };
  fill(plan, cell(left, plan.corner_m.x()), cell(low, plan.corner_m.y()), cell(right, plan.corner_m.x()),
       cell(high, plan.corner_m.y()), ground);
}

inline const Pose2 kTruth{12, -7, 2.1};

struct TwoMaps {
  Plan old_map = hall(), new_map = hall();  // the new one still in the coordinates of the old one
  render::PlacedGrid newGrid() const { return gridOf(mappedAgain(new_map, kTruth, 0.05)); }
  carry::Site site() const { return {gridOf(old_map), newGrid(), kTruth}; }
};

}  // namespace mapwright::testing
