#include "grids/grid_pyramid.h"

namespace mapwright::grids {

std::uint8_t GridPyramid::at(int column, int row) const {
  const std::uint8_t unknown = unknownByte(code());
  if (column < 0 || row < 0 || column >= width() || row >= height()) return unknown;
  const auto found = tileAtHand(0, column / kTileEdge, row / kTileEdge);
  if (!found) return unknown;
  return found->cells.get()[(row % kTileEdge) * kTileEdge + column % kTileEdge];
}

}  // namespace mapwright::grids
