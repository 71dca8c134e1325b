// Cells and containers for the tests, made by other libraries than those under test where there are any.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "cells/cell_texture.h"

namespace mapwright::cells::samples {

using Bytes = std::vector<std::uint8_t>;

/// A round blob of cells as Cartographer paints them (value and alpha exclude each other), unknown around it.
inline std::vector<CellPair> blob(int width, int height, std::uint32_t seed, double radius_share = 0.36) {
  std::minstd_rand random(seed);
  std::vector<CellPair> cells(std::size_t(width) * std::size_t(height));
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const double x = (u + 0.5) / width - 0.5;
      const double y = (v + 0.5) / height - 0.5;
      if (x * x + y * y > radius_share * radius_share) {
        continue;
      }
      const auto amount = std::uint8_t(1 + random() % 127);
      cells[std::size_t(v) * std::size_t(width) + std::size_t(u)] =
          random() % 4 == 0 ? CellPair{0, amount} : CellPair{amount, 0};
    }
  }
  return cells;
}

inline Bytes interleaved(std::span<const CellPair> cells) {
  Bytes bytes;
  bytes.reserve(2 * cells.size());
  for (const CellPair& cell : cells) {
    bytes.push_back(cell.value);
    bytes.push_back(cell.alpha);
  }
  return bytes;
}

}  // namespace mapwright::cells::samples
