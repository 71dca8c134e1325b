#include "grids/grid_pyramid.h"

#include <cstring>

namespace mapwright::grids {

std::uint8_t GridPyramid::at(int column, int row) const {
  const std::uint8_t unknown = unknownByte(code());
  if (column < 0 || row < 0 || column >= width() || row >= height()) return unknown;
  const auto found = tileAtHand(0, column / kTileEdge, row / kTileEdge);
  if (!found) return unknown;
  return found->cells.get()[(row % kTileEdge) * kTileEdge + column % kTileEdge];
}

GridRows::GridRows(const GridPyramid& cells)
    : cells_(cells),
      band_(std::size_t((cells.width() + GridPyramid::kTileEdge - 1) / GridPyramid::kTileEdge)),
      row_(band_.size() * std::size_t(GridPyramid::kTileEdge)) {}

const std::uint8_t* GridRows::row(int y) {
  constexpr int kEdge = GridPyramid::kTileEdge;
  if (tile_row_ != y / kEdge) {
    tile_row_ = y / kEdge;
    for (std::size_t x = 0; x < band_.size(); ++x) band_[x] = cells_.tile(0, int(x), tile_row_);
  }
  for (std::size_t x = 0; x < band_.size(); ++x) {
    std::uint8_t* const out = row_.data() + x * kEdge;
    if (band_[x]) {
      std::memcpy(out, band_[x]->cells.get() + std::size_t(y % kEdge) * kEdge, kEdge);
    } else {
      std::memset(out, unknownByte(cells_.code()), kEdge);
    }
  }
  return row_.data();
}

}  // namespace mapwright::grids
