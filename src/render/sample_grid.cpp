#include "render/sample_grid.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace mapwright::render {
namespace {

using raster::GridPyramid;
using raster::GridTile;

constexpr int kEdge = GridPyramid::kTileEdge;
constexpr int kEdgeBits = 8;
static_assert(1 << kEdgeBits == kEdge);
constexpr int kMostTiles = 4096;  // of one window: far more than any view tile touches
constexpr double kTouch = 1e-6;   // of a cell: less than this is not touched

/// The tiles of one level that a window touches, fetched once.
class TileWindow {
 public:
  /// Cells [u0, u1] x [v0, v1], clamped to the level; empty when they miss it.
  TileWindow(const GridPyramid& cells, int level, double u0, double v0, double u1, double v1)
      : width_(cells.levelWidth(level)), height_(cells.levelHeight(level)) {
    if (!(u0 < width_ && v0 < height_ && u1 >= 0 && v1 >= 0)) return;
    first_x_ = int(std::max(u0, 0.0)) >> kEdgeBits;
    first_y_ = int(std::max(v0, 0.0)) >> kEdgeBits;
    const int last_x = int(std::min(u1, width_ - 1.0)) >> kEdgeBits;
    const int last_y = int(std::min(v1, height_ - 1.0)) >> kEdgeBits;
    columns_ = last_x - first_x_ + 1;
    const int rows = last_y - first_y_ + 1;
    if (std::int64_t(columns_) * rows > kMostTiles) {
      columns_ = 0;
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
  int width() const { return width_; }
  int height() const { return height_; }
  /// nullptr where not read yet. Precondition: inside the level and the window.
  const std::uint8_t* at(int u, int v) const {
    const std::uint8_t* const tile = data_[std::size_t((v >> kEdgeBits) - first_y_) * std::size_t(columns_) +
                                           std::size_t((u >> kEdgeBits) - first_x_)];
    return tile ? tile + (((v & (kEdge - 1)) << kEdgeBits) | (u & (kEdge - 1))) : nullptr;
  }

 private:
  int width_, height_;
  int first_x_ = 0, first_y_ = 0, columns_ = 0;
  std::vector<GridTile> tiles_;
  std::vector<const std::uint8_t*> data_;
};

/// From pixels of the window to cells of a level, as an affine map.
struct CellsOfPixels {
  Eigen::Vector2d origin, per_column, per_row;
  double cells_per_pixel;  // of the level

  CellsOfPixels(const PixelGrid& grid, const map::GridReference& reference, int level) {
    const double shrink = std::ldexp(1.0, -level);
    const auto cell = [&](double column, double row) {
      return Eigen::Vector2d(reference.cellFromWorld(grid.worldFromPixel(column, row)) * shrink);
    };
    origin = cell(0, 0);
    // Over the whole window: differences of neighbours would lose digits far from the origin.
    per_column = (cell(grid.width_px, 0) - origin) / grid.width_px;
    per_row = (cell(0, grid.height_px) - origin) / grid.height_px;
    cells_per_pixel = grid.scale_m_per_px / reference.resolution_m * shrink;
  }
  Eigen::Vector2d at(double column, double row) const { return origin + per_column * column + per_row * row; }
};

struct Footprint {
  int u0, u1, v0, v1;  // cells touched, inclusive
};

/// What a footprint comes to.
class Reducer {
 public:
  Reducer(const TileWindow& window, const raster::CellMeaning& meaning, raster::Reduction reduction)
      : window_(window), meaning_(meaning), average_(reduction == raster::Reduction::Average) {}

  /// Writes the byte; false where nothing has been read.
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
        if (cell && meaning_.rank[*cell] > best) {
          best = meaning_.rank[*cell];
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
    // An average of gray levels on both sides of the unknown band is known all the same.
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
  const raster::CellMeaning& meaning_;
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

}  // namespace

Composition sampleGrid(const PixelGrid& grid, const PlacedGrid& placed, const std::atomic<bool>* cancelled,
                       Sampling sampling) {
  if (grid.width_px <= 0 || grid.height_px <= 0) return {};
  Composition pixels = emptyRaster(grid);
  if (!placed.cells || map::whyUnusable(placed.reference) || !(grid.scale_m_per_px > 0) ||
      !std::isfinite(placed.reference.origin.yaw_rad)) {
    return pixels;
  }
  const GridPyramid& cells = *placed.cells;
  const double zoom = grid.scale_m_per_px / placed.reference.resolution_m;
  // One level finer than would do: then a pixel is at least two cells wide, and what it touches is told well.
  int level = std::clamp(int(std::floor(std::log2(zoom) + 1e-9)) - 1, 0, cells.levels() - 1);
  if (sampling == Sampling::Exact && zoom <= kExactCells) level = 0;
  const CellsOfPixels to_cell(grid, placed.reference, level);
  const bool reduced = zoom > 1 + 1e-9;

  geometry::WorldRect touched;  // in cells
  for (const double x : {0.0, double(grid.width_px)}) {
    for (const double y : {0.0, double(grid.height_px)}) touched.extend(to_cell.at(x, y));
  }
  const double margin = reduced ? to_cell.cells_per_pixel : 0;
  const TileWindow window(cells, level, touched.min_x - margin, touched.min_y - margin,
                          touched.max_x + margin, touched.max_y + margin);
  if (window.empty()) return pixels;

  const auto mark = [&](std::size_t at, std::uint8_t cell) {
    pixels.intensity[at] = cell;
    pixels.flags[at] = kObserved;
  };
  const Reducer reduce(window, raster::meaningOf(cells.code()), cells.reduction());
  // Half of the footprint's extent along each cell axis: the pixel's own bounding box when turned.
  const double half = to_cell.cells_per_pixel / 2;
  const double turn = (std::abs(to_cell.per_column.x()) + std::abs(to_cell.per_row.x())) /
                      std::max(to_cell.cells_per_pixel, 1e-300);
  const double reach = sampling == Sampling::Exact ? half : half * std::clamp(turn, 1.0, 1.5);
  std::size_t at = 0;
  for (int row = 0; row < grid.height_px; ++row) {
    if (cancelled && cancelled->load(std::memory_order_relaxed)) return {};
    for (int column = 0; column < grid.width_px; ++column, ++at) {
      const Eigen::Vector2d centre = to_cell.at(column + 0.5, row + 0.5);
      if (!reduced) {
        const double u = std::floor(centre.x()), v = std::floor(centre.y());
        if (!(u >= 0 && v >= 0 && u < window.width() && v < window.height())) continue;
        if (const std::uint8_t* const cell = window.at(int(u), int(v))) mark(at, *cell);
        continue;
      }
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
      if (reduce(print, centre, half, cell)) mark(at, cell);
    }
  }
  return pixels;
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
                         const std::atomic<bool>* cancelled) {
  Composition a = sampleGrid(grid, first, cancelled);
  const Composition b = sampleGrid(grid, second, cancelled);
  if (a.width_px == 0 || b.width_px == 0 || !first.cells || !second.cells) return {};
  const raster::CellMeaning& meaning_a = raster::meaningOf(first.cells->code());
  const raster::CellMeaning& meaning_b = raster::meaningOf(second.cells->code());
  for (std::size_t at = 0; at < a.intensity.size(); ++at) {
    const std::uint8_t cell_a = a.intensity[at], cell_b = b.intensity[at];
    const bool known_a = a.flags[at] && meaning_a.known[cell_a];
    const bool known_b = b.flags[at] && meaning_b.known[cell_b];
    const Difference difference =
        differenceOf(known_a, meaning_a.occupancy[cell_a], known_b, meaning_b.occupancy[cell_b]);
    a.intensity[at] = std::uint8_t(difference);
    a.flags[at] = a.flags[at] | b.flags[at];
  }
  return a;
}

}  // namespace mapwright::render
