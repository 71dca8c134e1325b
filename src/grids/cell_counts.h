// How many cells of a map are free, occupied and unknown. Pure; takes about a second for a billion cells.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

#include "grids/grid_pyramid.h"

namespace mapwright::grids {

/// Cells of so many percent and more are occupied, as everywhere in the program.
inline constexpr int kOccupiedPercent = 50;

/// What has not been read is unknown.
struct CellCounts {
  std::int64_t free = 0, occupied = 0, unknown = 0;
  std::int64_t all() const { return free + occupied + unknown; }
  bool operator==(const CellCounts&) const = default;
};

/// nullopt: cancelled.
std::optional<CellCounts> countCells(const GridPyramid& cells, const std::atomic<bool>& cancelled);

}  // namespace mapwright::grids
