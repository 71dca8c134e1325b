// Small maps as text: '.' free, '#' occupied, ' ' unknown. Row 0 on top; cells of 10 cm, the lower left
// corner at (0, 0).
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "grids/grid_pyramid.h"
#include "placing/ground.h"

namespace mapwright::test {

inline placing::PlacedMap mapOf(int width, int height, const std::function<char(int, int)>& letter,
                                grids::Reduction reduction = grids::Reduction::OccupiedWins) {
  const auto builder = grids::buildGrid(width, height, grids::CellCode::Occupancy, reduction);
  std::vector<std::uint8_t> row(static_cast<std::size_t>(width));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const char c = letter(x, y);
      row[std::size_t(x)] = c == '#' ? 100 : c == '.' ? 0 : grids::kUnknownOccupancy;
    }
    builder->pushRow(row);
  }
  builder->finish();
  map::GridReference reference;
  reference.width = width;
  reference.height = height;
  reference.resolution_m = 0.1;
  return {builder->pyramid(), reference};
}

inline placing::PlacedMap mapOf(const std::vector<std::string>& rows) {
  return mapOf(int(rows[0].size()), int(rows.size()),
               [&](int x, int y) { return rows[std::size_t(y)][std::size_t(x)]; });
}

inline std::uint32_t noise(std::uint32_t seed) {
  seed ^= seed >> 16;
  seed *= 0x7feb352d;
  seed ^= seed >> 15;
  seed *= 0x846ca68b;
  return seed ^ seed >> 16;
}

}  // namespace mapwright::test
