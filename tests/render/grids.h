// Small occupancy grids for tests.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "grids/grid_pyramid.h"
#include "render/sample_grid.h"

namespace mapwright::test {

/// A grid of gray cells: cell(column, row from the top).
inline render::PlacedGrid gridOf(int width, int height, double resolution_m, const geometry::Pose2& origin,
                                 const std::function<int(int, int)>& cell,
                                 grids::Reduction reduction = grids::Reduction::OccupiedWins,
                                 grids::CellCode code = grids::CellCode::Gray) {
  const auto builder = grids::buildGrid(width, height, code, reduction);
  std::vector<std::uint8_t> row(std::size_t(width), 0);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) row[std::size_t(u)] = std::uint8_t(cell(u, v));
    builder->pushRow(row);
  }
  builder->finish();
  return {builder->pyramid(), {width, height, resolution_m, origin}};
}

}  // namespace mapwright::test
