// Sampling occupancy grids into the pixels of a view: exact cells when magnified, nothing lost when reduced.
// Pure functions, any thread.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>

#include "grids/grid_pyramid.h"
#include "map/grid_reference.h"
#include "render/compositor.h"

namespace mapwright::render {

/// A grid where it lies. The reference has the pyramid's width and height.
struct PlacedGrid {
  std::shared_ptr<const grids::GridPyramid> cells;
  map::GridReference reference;
  bool operator==(const PlacedGrid&) const = default;
};

/// Beside kObserved in the flags of a sampled grid: the byte is the mean of known cells, though it is one
/// that by itself reads as unknown (128 between black and white in a gray picture).
inline constexpr std::uint8_t kKnownMean = 16;

/// The cell bytes under the pixels of `grid`, row-major: Composition::intensity holds the byte in the
/// pyramid's own code, flags is kObserved where the pixel touches the grid and its cell has been read.
///
/// A pixel no larger than a cell shows the cell under its centre. A larger one shows what the cells that it
/// touches come to by the pyramid's reduction: the highest rank, or the average by area of the known ones
/// (unknown where less than half of the ground is known). The pixel is the square that it is, turned as the
/// view is turned against the grid; a cell is touched when the two share more than an edge.
/// A grid whose numbers are unusable (map::whyUnusable) gives nothing.
///
/// Sampling::Quick reads from a level of detail, so that what a large pixel touches is rounded up to at most
/// half a pixel and averages are averages of averages: for a first look.
enum class Sampling { Quick, Exact };
Composition sampleGrid(const PixelGrid& grid, const PlacedGrid& placed, const std::atomic<bool>* cancelled,
                       Sampling sampling = Sampling::Exact);
/// Both kinds of sampling give the same, as where an upright pixel is less than four cells wide.
bool quickIsExact(const PixelGrid& grid, const PlacedGrid& placed);

/// What a sampled pixel means.
bool knownIn(const Composition& pixels, std::size_t at, const grids::CellMeaning& meaning);
int occupancyIn(const Composition& pixels, std::size_t at, const grids::CellMeaning& meaning);

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
                         const std::atomic<bool>* cancelled, Sampling sampling = Sampling::Exact);

}  // namespace mapwright::render
