// A level of a texture as the inner loops read it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "cells/cell_texture.h"

namespace mapwright::render {

/// A level prepared for the inner loops. `level` has its size, stride and empty blocks; its own data has been
/// released.
/// Folded: two bytes per cell, the cell and the one below it, so that one 32-bit load at a cell gets all four
/// bilinear taps (top left, bottom left, top right, bottom right). Pairs: value and alpha as in
/// cells::DenseCells. Cell (column u, row v) starts at taps[((v + kBorder) * stride + (u + kBorder)) *
/// kBytesPerCell].
struct TapCells {
  static constexpr int kBytesPerCell = 2;
  cells::DenseCells level;
  std::unique_ptr<const std::uint8_t[]> taps;
  std::size_t tap_bytes = 0;
  std::size_t bytes() const { return tap_bytes + level.bytes(); }
};
/// `given_up` receives the memory of `dense`, which is no longer needed.
TapCells tapCellsOf(cells::DenseCells dense, std::vector<std::uint8_t>* given_up = nullptr);

}  // namespace mapwright::render
