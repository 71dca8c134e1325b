#include "render/sample_grid.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/touched_cells.h"

namespace mapwright::render {
namespace {

using grids::GridPyramid;
using grids::GridTile;

constexpr int kEdgeBits = 8;
static_assert(1 << kEdgeBits == GridPyramid::kTileEdge);
constexpr int kMostTiles = 4096;  // of one window: far more than any view tile touches
constexpr int kBlock = 16;        // pixels
constexpr double kUpright = 1e-9;
// Cells a pixel. 0.05 m as a float is a hair more than 0.05: no reason to touch two cells with each pixel,
// and to draw every wall half a cell off.
constexpr double kNoLarger = 1 + 1e-6;

bool stopped(const std::atomic<bool>* cancelled) {
  return cancelled && cancelled->load(std::memory_order_relaxed);
}

/// The tiles of one level that a window touches, fetched once.
class TileWindow {
 public:
  /// Cells [u0, u1] x [v0, v1], clamped to the level; empty when they miss it.
  TileWindow(const GridPyramid& cells, int level, double u0, double v0, double u1, double v1)
      : width_(cells.levelWidth(level)),
        height_(cells.complete() ? cells.levelHeight(level) : cells.rowsReady() >> level) {
    if (!(u0 < width_ && v0 < height_ && u1 >= 0 && v1 >= 0)) return;
    first_x_ = int(std::max(u0, 0.0)) >> kEdgeBits;
    first_y_ = int(std::max(v0, 0.0)) >> kEdgeBits;
    const int last_x = int(std::min(u1, width_ - 1.0)) >> kEdgeBits;
    const int last_y = int(std::min(v1, height_ - 1.0)) >> kEdgeBits;
    columns_ = last_x - first_x_ + 1;
    const int rows = last_y - first_y_ + 1;
    if (std::int64_t(columns_) * rows > kMostTiles) {
      columns_ = 0;
      too_large_ = true;
      return;
    }
    tiles_.resize(std::size_t(columns_) * std::size_t(rows));
    data_.resize(tiles_.size());
    for (int y = 0; y < rows; ++y) {
      for (int x = 0; x < columns_; ++x) {
        const auto at = std::size_t(y) * std::size_t(columns_) + std::size_t(x);
        if (auto tile = cells.tile(level, first_x_ + x, first_y_ + y)) {
          tiles_[at] = std::move(*tile);
          data_[at] = tiles_[at].cells.get();
        }
      }
    }
  }

  bool empty() const { return columns_ == 0; }
  bool tooLarge() const { return too_large_; }
  int width() const { return width_; }
  int height() const { return height_; }
  /// nullptr where not read yet. Precondition: inside the level and the window.
  const std::uint8_t* at(int u, int v) const {
    const std::uint8_t* const tile = data_[std::size_t((v >> kEdgeBits) - first_y_) * std::size_t(columns_) +
                                           std::size_t((u >> kEdgeBits) - first_x_)];
    return tile ? tile +
                      (((v & (GridPyramid::kTileEdge - 1)) << kEdgeBits) | (u & (GridPyramid::kTileEdge - 1)))
                : nullptr;
  }

 private:
  int width_, height_;
  int first_x_ = 0, first_y_ = 0, columns_ = 0;
  bool too_large_ = false;
  std::vector<GridTile> tiles_;
  std::vector<const std::uint8_t*> data_;
};

struct Footprint {
  int u0, u1, v0, v1;  // cells touched, inclusive
};

/// The value of a footprint, for a preview.
class Reducer {
 public:
  Reducer(const TileWindow& window, const GridPyramid& cells)
      : window_(window),
        meaning_(grids::meaningOf(cells.code())),
        order_(cells.order()),
        average_(cells.reduction() == grids::Reduction::Average) {}

  /// Writes the byte; false if nothing has been read.
  bool operator()(const Footprint& print, const Eigen::Vector2d& centre, double half,
                  std::uint8_t& out) const {
    return average_ ? average(print, centre, half, out) : highest(print, out);
  }

 private:
  bool highest(const Footprint& print, std::uint8_t& out) const {
    int best = -1;
    for (int v = print.v0; v <= print.v1; ++v) {
      for (int u = print.u0; u <= print.u1; ++u) {
        const std::uint8_t* const cell = window_.at(u, v);
        if (cell && order_[*cell] > best) {
          best = order_[*cell];
          out = *cell;
        }
      }
    }
    return best >= 0;
  }

  bool average(const Footprint& print, const Eigen::Vector2d& centre, double half, std::uint8_t& out) const {
    double sum = 0, known = 0, read = 0;
    const auto overlap = [half](double middle, int cell) {
      return std::max(0.0, std::min(middle + half, cell + 1.0) - std::max(middle - half, double(cell)));
    };
    std::uint8_t unknown = 0;
    for (int v = print.v0; v <= print.v1; ++v) {
      const double weight_v = overlap(centre.y(), v);
      for (int u = print.u0; u <= print.u1; ++u) {
        const std::uint8_t* const cell = window_.at(u, v);
        if (!cell) continue;
        const double weight = weight_v * overlap(centre.x(), u);
        read += weight;
        if (meaning_.known[*cell]) {
          known += weight;
          sum += weight * *cell;
        } else {
          unknown = *cell;
        }
      }
    }
    if (read <= 0) return false;
    if (known * 2 < read) {
      out = unknown;
      return true;
    }
    out = std::uint8_t(std::clamp(std::lround(sum / known), 0L, 255L));
    // An average of gray levels on both sides of the unknown range is still known.
    if (!meaning_.known[out]) out = nearestKnown(out);
    return true;
  }

  std::uint8_t nearestKnown(std::uint8_t byte) const {
    for (int away = 1; away < 256; ++away) {
      if (byte + away < 256 && meaning_.known[std::size_t(byte + away)]) return std::uint8_t(byte + away);
      if (byte - away >= 0 && meaning_.known[std::size_t(byte - away)]) return std::uint8_t(byte - away);
    }
    return byte;
  }

  const TileWindow& window_;
  const grids::CellMeaning& meaning_;
  const std::array<std::uint8_t, 256>& order_;
  bool average_;
};

Composition emptyRaster(const PixelGrid& grid) {
  Composition pixels;
  pixels.width_px = grid.width_px;
  pixels.height_px = grid.height_px;
  const std::size_t count = std::size_t(grid.width_px) * std::size_t(grid.height_px);
  pixels.intensity.assign(count, 128);
  pixels.flags.assign(count, 0);
  return pixels;
}

/// For pixels no larger than a cell.
void sampleNearest(const PixelGrid& grid, const CellsOfPixels& to_cell, TileReach& reach, Composition& pixels,
                   const std::atomic<bool>* cancelled) {
  std::size_t at = 0;
  for (int row = 0; row < grid.height_px; ++row) {
    if (stopped(cancelled)) return;
    for (int column = 0; column < grid.width_px; ++column, ++at) {
      const Eigen::Vector2d centre = to_cell.at(column + 0.5, row + 0.5);
      const double u = std::floor(centre.x()), v = std::floor(centre.y());
      if (!(u >= 0 && v >= 0 && u < reach.width() && v < reach.rows())) continue;
      if (const std::uint8_t* const cell = reach.at(0, int(u), int(v))) {
        pixels.intensity[at] = *cell;
        pixels.flags[at] = kObserved;
      }
    }
  }
}

/// Block by block, so that the tiles under a block stay in the cache.
template <typename Sample>
void sampleBlocks(const PixelGrid& grid, const CellsOfPixels& to_cell, const std::atomic<bool>* cancelled,
                  Sample sample) {
  for (int top = 0; top < grid.height_px; top += kBlock) {
    for (int left = 0; left < grid.width_px; left += kBlock) {
      if (stopped(cancelled)) return;
      for (int row = top; row < std::min(top + kBlock, grid.height_px); ++row) {
        for (int column = left; column < std::min(left + kBlock, grid.width_px); ++column) {
          sample(to_cell.at(column + 0.5, row + 0.5),
                 std::size_t(row) * std::size_t(grid.width_px) + std::size_t(column));
        }
      }
    }
  }
}

void sampleTouched(const PixelGrid& grid, const CellsOfPixels& to_cell, const GridPyramid& cells,
                   TileReach& reach, Composition& pixels, const std::atomic<bool>* cancelled) {
  const PixelOnCells square(to_cell);
  std::uint8_t byte = 0;
  if (cells.reduction() == grids::Reduction::Average) {
    MeanTouched mean(cells, reach, square);
    const grids::CellMeaning& meaning = grids::meaningOf(cells.code());
    bool known = false;
    sampleBlocks(grid, to_cell, cancelled, [&](const Eigen::Vector2d& centre, std::size_t at) {
      if (!mean(centre, byte, known)) return;
      pixels.intensity[at] = byte;
      pixels.flags[at] = std::uint16_t(kObserved | (known && !meaning.known[byte] ? kKnownMean : 0));
    });
    return;
  }
  HighestTouched highest(cells, reach, square);
  sampleBlocks(grid, to_cell, cancelled, [&](const Eigen::Vector2d& centre, std::size_t at) {
    if (!highest(centre, byte)) return;
    pixels.intensity[at] = byte;
    pixels.flags[at] = kObserved;
  });
}

/// From a coarser level: the touched area is rounded up by at most half a pixel, and a rotated pixel counts
/// as its bounding square. False: the window is too large for that.
bool sampleLevel(const PixelGrid& grid, const PlacedGrid& placed, int level, Composition& pixels,
                 const std::atomic<bool>* cancelled) {
  const GridPyramid& cells = *placed.cells;
  const CellsOfPixels to_cell(grid, placed.reference, level);
  geometry::WorldRect touched;  // in cells
  for (const double x : {0.0, double(grid.width_px)}) {
    for (const double y : {0.0, double(grid.height_px)}) touched.extend(to_cell.at(x, y));
  }
  const double margin = to_cell.cells_per_pixel;
  const TileWindow window(cells, level, touched.min_x - margin, touched.min_y - margin,
                          touched.max_x + margin, touched.max_y + margin);
  if (window.empty()) return !window.tooLarge();
  const Reducer reduce(window, cells);
  // Half the footprint's extent along each cell axis: the pixel's bounding box if rotated.
  const double half = to_cell.cells_per_pixel / 2;
  const double turn = (std::abs(to_cell.per_column.x()) + std::abs(to_cell.per_row.x())) /
                      std::max(to_cell.cells_per_pixel, 1e-300);
  const double reach = half * std::clamp(turn, 1.0, 1.5);
  std::size_t at = 0;
  for (int row = 0; row < grid.height_px; ++row) {
    if (stopped(cancelled)) return true;
    for (int column = 0; column < grid.width_px; ++column, ++at) {
      const Eigen::Vector2d centre = to_cell.at(column + 0.5, row + 0.5);
      Footprint print;
      const double u0 = std::floor(centre.x() - reach + kTouch),
                   u1 = std::ceil(centre.x() + reach - kTouch) - 1;
      const double v0 = std::floor(centre.y() - reach + kTouch),
                   v1 = std::ceil(centre.y() + reach - kTouch) - 1;
      if (!(u1 >= 0 && v1 >= 0 && u0 < window.width() && v0 < window.height())) continue;
      print.u0 = int(std::max(u0, 0.0));
      print.v0 = int(std::max(v0, 0.0));
      print.u1 = int(std::min(u1, window.width() - 1.0));
      print.v1 = int(std::min(v1, window.height() - 1.0));
      std::uint8_t cell = 0;
      if (!reduce(print, centre, half, cell)) continue;
      pixels.intensity[at] = cell;
      pixels.flags[at] = kObserved;
    }
  }
  return true;
}

bool drawable(const PixelGrid& grid, const PlacedGrid& placed) {
  return placed.cells && !map::unusableReason(placed.reference) && grid.scale_m_per_px > 0 &&
         std::isfinite(placed.reference.origin.yaw_rad);
}

double cellsPerPixel(const PixelGrid& grid, const PlacedGrid& placed) {
  return grid.scale_m_per_px / placed.reference.resolution_m;
}

/// The level for a preview. One finer than necessary: then a pixel is at least two cells wide, and its area
/// is well approximated.
int quickLevel(const PixelGrid& grid, const PlacedGrid& placed) {
  const double zoom = cellsPerPixel(grid, placed);
  return std::clamp(int(std::floor(std::log2(zoom) + 1e-9)) - 1, 0, placed.cells->levels() - 1);
}

/// The sides of the pixels run along the cells.
bool upright(const PixelGrid& grid, const PlacedGrid& placed) {
  const CellsOfPixels to_cell(grid, placed.reference, 0);
  const double across = std::abs(to_cell.per_column.x()), along = std::abs(to_cell.per_column.y());
  return std::min(across, along) <= kUpright * std::max(across, along);
}

}  // namespace

bool quickIsExact(const PixelGrid& grid, const PlacedGrid& placed) {
  if (!drawable(grid, placed) || cellsPerPixel(grid, placed) <= kNoLarger) return true;
  if (quickLevel(grid, placed) > 0) return false;
  return placed.cells->reduction() == grids::Reduction::Average || upright(grid, placed);
}

Composition sampleGrid(const PixelGrid& grid, const PlacedGrid& placed, const std::atomic<bool>* cancelled,
                       Sampling sampling) {
  if (grid.width_px <= 0 || grid.height_px <= 0) return {};
  Composition pixels = emptyRaster(grid);
  if (!drawable(grid, placed)) return pixels;
  const bool exactly = quickIsExact(grid, placed), larger = cellsPerPixel(grid, placed) > kNoLarger;
  const bool average = placed.cells->reduction() == grids::Reduction::Average;
  // Upright pixels of few cells touch exactly what the preview assumes.
  const bool by_level = larger && (sampling == Sampling::Quick ? !exactly || !average : exactly && !average);
  if (!by_level || !sampleLevel(grid, placed, quickLevel(grid, placed), pixels, cancelled)) {
    const CellsOfPixels to_cell(grid, placed.reference, 0);
    TileReach reach(*placed.cells);
    if (larger) {
      sampleTouched(grid, to_cell, *placed.cells, reach, pixels, cancelled);
    } else {
      sampleNearest(grid, to_cell, reach, pixels, cancelled);
    }
  }
  if (stopped(cancelled)) return {};
  return pixels;
}

bool knownIn(const Composition& pixels, std::size_t at, const grids::CellMeaning& meaning) {
  return pixels.flags[at] != 0 &&
         (meaning.known[pixels.intensity[at]] || (pixels.flags[at] & kKnownMean) != 0);
}

int occupancyIn(const Composition& pixels, std::size_t at, const grids::CellMeaning& meaning) {
  const std::uint8_t byte = pixels.intensity[at];
  // Only for grays may a mean of known cells mean unknown.
  return (pixels.flags[at] & kKnownMean) != 0 ? int(std::lround((255 - byte) * 100 / 255.0))
                                              : int(meaning.occupancy[byte]);
}

Difference differenceOf(bool known_first, int occupancy_first, bool known_second, int occupancy_second) {
  if (!known_first && !known_second) return Difference::None;
  if (!known_second) return Difference::OnlyFirst;
  if (!known_first) return Difference::OnlySecond;
  const bool full_first = occupancy_first >= 50, full_second = occupancy_second >= 50;
  if (full_first) return full_second ? Difference::SameOccupied : Difference::Vanished;
  return full_second ? Difference::Appeared : Difference::SameFree;
}

Composition compareGrids(const PixelGrid& grid, const PlacedGrid& first, const PlacedGrid& second,
                         const std::atomic<bool>* cancelled, Sampling sampling) {
  Composition a = sampleGrid(grid, first, cancelled, sampling);
  const Composition b = sampleGrid(grid, second, cancelled, sampling);
  if (a.width_px == 0 || b.width_px == 0 || !first.cells || !second.cells) return {};
  const grids::CellMeaning& meaning_a = grids::meaningOf(first.cells->code());
  const grids::CellMeaning& meaning_b = grids::meaningOf(second.cells->code());
  for (std::size_t at = 0; at < a.intensity.size(); ++at) {
    const Difference difference = differenceOf(knownIn(a, at, meaning_a), occupancyIn(a, at, meaning_a),
                                               knownIn(b, at, meaning_b), occupancyIn(b, at, meaning_b));
    a.intensity[at] = std::uint8_t(difference);
    a.flags[at] = (a.flags[at] | b.flags[at]) & kObserved;
  }
  return a;
}

}  // namespace mapwright::render
