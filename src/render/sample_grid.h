// Samples occupancy grids into the pixels of a view: exact cells when magnified, nothing lost when reduced.
// Pure functions, any thread.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>

#include "map/grid_reference.h"
#include "render/compositor.h"

namespace mapwright::grids {
class GridPyramid;
struct CellMeaning;
}  // namespace mapwright::grids

namespace mapwright::render {

/// A grid at its position. The reference has the pyramid's width and height.
struct PlacedGrid {
  std::shared_ptr<const grids::GridPyramid> cells;
  map::GridReference reference;
  bool operator==(const PlacedGrid&) const = default;
};

/// In addition to kObserved in the flags of a sampled grid: the byte is the mean of known cells, although it
/// would mean unknown by itself (128 between black and white in a gray picture).
inline constexpr std::uint8_t kKnownMean = 16;

/// The cell bytes under the pixels of `grid`, row-major: Composition::intensity is the byte in the pyramid's
/// own code, flags is kObserved if the pixel touches the grid and its cell has been read.
/// A pixel no larger than a cell shows the cell under its centre. A larger one combines all touched cells by
/// the pyramid's reduction: the highest rank, or the average by area of the known ones (unknown if less than
/// half the area is known). The pixel is an exact square, rotated as the view is against the grid; a cell is
/// touched if the two overlap by more than an edge. A grid with invalid numbers (map::unusableReason) gives
/// nothing.
/// Sampling::Quick reads from a coarser level, so that the area of a large pixel is rounded up by at most
/// half a pixel and averages are averages of averages: for previews.
enum class Sampling { Quick, Exact };
Composition sampleGrid(const PixelGrid& grid, const PlacedGrid& placed, const std::atomic<bool>* cancelled,
                       Sampling sampling = Sampling::Exact);
/// Both kinds of sampling give the same result, for example if an upright pixel is less than four cells wide.
bool quickIsExact(const PixelGrid& grid, const PlacedGrid& placed);

/// The meaning of a sampled pixel.
bool knownIn(const Composition& pixels, std::size_t at, const grids::CellMeaning& meaning);
int occupancyIn(const Composition& pixels, std::size_t at, const grids::CellMeaning& meaning);

/// The result of comparing two maps at a pixel; the codes of compareGrids().
enum class Difference : std::uint8_t {
  None,          // unknown in both
  SameFree,      // free in both
  SameOccupied,  // occupied in both
  Appeared,      // occupied only in the second, free in the first
  Vanished,      // occupied only in the first, free in the second
  OnlyFirst,     // known in the first only
  OnlySecond,    // known in the second only
};
inline constexpr int kDifferences = 7;

/// `known`: read and not unknown; `occupancy`: percent. Occupied: 50 or more.
Difference differenceOf(bool known_first, int occupancy_first, bool known_second, int occupancy_second);

/// The same raster with Difference codes as bytes.
Composition compareGrids(const PixelGrid& grid, const PlacedGrid& first, const PlacedGrid& second,
                         const std::atomic<bool>* cancelled, Sampling sampling = Sampling::Exact);

}  // namespace mapwright::render
