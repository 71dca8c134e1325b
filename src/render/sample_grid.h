// Sampling occupancy grids into the pixels of a view: exact cells when magnified, nothing lost when reduced.
// Pure functions, any thread.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>

#include "map/grid_reference.h"
#include "raster/grid_pyramid.h"
#include "render/compositor.h"

namespace mapwright::render {

/// A grid where it lies. The reference has the pyramid's width and height.
struct PlacedGrid {
  std::shared_ptr<const raster::GridPyramid> cells;
  map::GridReference reference;
  bool operator==(const PlacedGrid&) const = default;
};

/// The cell bytes under the pixels of `grid`, row-major: Composition::intensity holds the byte in the
/// pyramid's own code, flags is kObserved where the pixel touches the grid and its cell has been read.
///
/// A pixel no larger than a cell shows the cell under its centre. A larger one shows what the cells that it
/// touches come to by the pyramid's reduction: the highest rank, or the average by area of the known ones.
/// A grid whose numbers are unusable (map::whyUnusable) gives nothing.
///
/// Sampling::View reads from a level of detail, so that what a large pixel touches is rounded up to at most
/// half a pixel. Sampling::Exact reads the cells themselves where a pixel is at most kExactCells of them
/// wide, and counts a turned pixel by its middle square.
enum class Sampling { View, Exact };
inline constexpr double kExactCells = 64;
Composition sampleGrid(const PixelGrid& grid, const PlacedGrid& placed, const std::atomic<bool>* cancelled,
                       Sampling sampling = Sampling::View);

/// How two maps compare at a pixel; the codes of compareGrids().
enum class Difference : std::uint8_t {
  None,          // unknown in both
  SameFree,      // free in both
  SameOccupied,  // occupied in both
  Appeared,      // occupied in the second only, free in the first
  Vanished,      // occupied in the first only, free in the second
  OnlyFirst,     // known in the first only
  OnlySecond,    // known in the second only
};
inline constexpr int kDifferences = 7;

/// `known`: it has been read and is not unknown; `occupancy`: percent. Occupied: 50 or more.
Difference differenceOf(bool known_first, int occupancy_first, bool known_second, int occupancy_second);

/// The same raster with Difference codes as bytes.
Composition compareGrids(const PixelGrid& grid, const PlacedGrid& first, const PlacedGrid& second,
                         const std::atomic<bool>* cancelled);

}  // namespace mapwright::render
