// Small maps as text: '.' free, '#' occupied, ' ' unknown.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "picture/canvas.h"
#include "picture/edited_grid.h"

namespace mapwright::test {

using grids::CellCode;
using picture::EditedGrid;
using picture::Kind;

inline std::shared_ptr<const grids::GridPyramid> pyramidOf(int width, int height,
                                                           const std::function<std::uint8_t(int, int)>& cell,
                                                           CellCode code = CellCode::Occupancy) {
  const auto builder = grids::buildGrid(width, height, code, grids::Reduction::OccupiedWins);
  std::vector<std::uint8_t> row(static_cast<std::size_t>(width));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) row[std::size_t(x)] = cell(x, y);
    builder->pushRow(row);
  }
  builder->finish();
  return builder->pyramid();
}

inline std::uint8_t byteOf(char letter) {
  return *picture::byteOf(letter == '.'   ? Kind::Free
                          : letter == '#' ? Kind::Occupied
                                          : Kind::Unknown,
                          CellCode::Occupancy);
}

inline std::shared_ptr<const grids::GridPyramid> pyramidOf(const std::vector<std::string>& rows) {
  return pyramidOf(int(rows[0].size()), int(rows.size()),
                   [&](int x, int y) { return byteOf(rows[std::size_t(y)][std::size_t(x)]); });
}

inline EditedGrid gridOf(const std::vector<std::string>& rows) { return EditedGrid(pyramidOf(rows)); }

inline std::vector<std::string> textOf(const grids::GridPyramid& grid) {
  const auto kinds = picture::kindsOf(grid.code());
  std::vector<std::string> rows;
  for (int y = 0; y < grid.height(); ++y) {
    rows.emplace_back();
    for (int x = 0; x < grid.width(); ++x) {
      const Kind kind = kinds[grid.at(x, y)];
      rows.back() += kind == Kind::Free ? '.' : kind == Kind::Occupied ? '#' : ' ';
    }
  }
  return rows;
}

inline std::uint32_t noise(std::uint32_t seed) {
  seed ^= seed >> 16;
  seed *= 0x7feb352d;
  seed ^= seed >> 15;
  seed *= 0x846ca68b;
  return seed ^ seed >> 16;
}

/// Free ground with walls and specks and unknown patches.
inline std::uint8_t speckled(int x, int y) {
  const std::uint32_t dice = noise(std::uint32_t(y) * 65'599u + std::uint32_t(x)) % 20;
  return byteOf(dice < 14 ? '.' : dice < 17 ? '#' : ' ');
}

}  // namespace mapwright::test
