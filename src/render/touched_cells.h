// Combines the cells touched by a pixel, exactly. Private to sampling; one thread.
// A cell is touched if it overlaps the rotated square of the pixel by more than an edge.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "grids/grid_pyramid.h"
#include "map/grid_reference.h"
#include "render/compositor.h"

namespace mapwright::render {

inline constexpr double kTouch = 1e-6;  // of a cell: smaller overlaps do not count

/// From window pixels to cells of a level, as an affine map.
struct CellsOfPixels {
  Eigen::Vector2d origin, per_column, per_row;
  double cells_per_pixel;  // of the level

  CellsOfPixels(const PixelGrid& grid, const map::GridReference& reference, int level) {
    const double shrink = std::ldexp(1.0, -level);
    const auto cell = [&](double column, double row) {
      return Eigen::Vector2d(reference.cellFromWorld(grid.worldFromPixel(column, row)) * shrink);
    };
    origin = cell(0, 0);
    // Over the whole window: differences of neighbours would lose precision far from the origin.
    per_column = (cell(grid.width_px, 0) - origin) / grid.width_px;
    per_row = (cell(0, grid.height_px) - origin) / grid.height_px;
    cells_per_pixel = grid.scale_m_per_px / reference.resolution_m * shrink;
  }
  Eigen::Vector2d at(double column, double row) const { return origin + per_column * column + per_row * row; }
};

/// The square that a pixel covers on level 0, at any rotation: the same for all pixels of a view except its
/// centre. Queries are about boxes of cells, given by their centre relative to the pixel's and half their
/// edges.
class PixelOnCells {
 public:
  explicit PixelOnCells(const CellsOfPixels& to_cell)
      : half_(to_cell.cells_per_pixel / 2),
        along_(to_cell.per_column.normalized()),
        slant_(std::abs(along_.x()) + std::abs(along_.y())),
        reach_(half_ * slant_) {}

  double half() const { return half_; }
  /// Half its extent along the axes of the cells.
  double reach() const { return reach_; }
  const Eigen::Vector2d& along() const { return along_; }
  /// The square and the box overlap by more than an edge.
  bool touches(double x, double y, double half_x, double half_y) const {
    if (std::abs(x) >= half_x + reach_ - kTouch || std::abs(y) >= half_y + reach_ - kTouch) return false;
    const double across = std::abs(x * along_.x() + y * along_.y());
    const double down = std::abs(y * along_.x() - x * along_.y());
    const double c = std::abs(along_.x()), s = std::abs(along_.y());
    return across < half_ + half_x * c + half_y * s - kTouch &&
           down < half_ + half_y * c + half_x * s - kTouch;
  }
  enum class Share { None, Part, All };
  /// How much of a box of cells with edges of 2 * `half_box` the square covers.
  Share shareOf(double x, double y, double half_box) const {
    const double edge = half_box + reach_ - kTouch;
    if (std::abs(x) >= edge || std::abs(y) >= edge) return Share::None;
    const double across = std::abs(x * along_.x() + y * along_.y());
    const double down = std::abs(y * along_.x() - x * along_.y());
    const double extent = half_box * slant_, farther = std::max(across, down);
    if (farther >= half_ + extent - kTouch) return Share::None;
    return farther + extent <= half_ + kTouch ? Share::All : Share::Part;
  }

 private:
  double half_;
  Eigen::Vector2d along_;  // unit vector of the columns
  double slant_, reach_;
};

/// Keeps the most recently used tiles, so that neighbouring pixels need not ask the pyramid again; bounded,
/// whatever the size of a pixel. Rows that have not been read are missing.
class TileReach {
 public:
  static constexpr int kEdge = grids::GridPyramid::kTileEdge;
  static constexpr int kEdgeBits = 8;
  static_assert(1 << kEdgeBits == kEdge);

  explicit TileReach(const grids::GridPyramid& cells)
      : cells_(cells), complete_(cells.complete()), rows_(cells.rowsReady()) {}

  /// If it was complete at construction, all its levels are available.
  bool complete() const { return complete_; }
  int width() const { return cells_.width(); }
  /// How many rows of level 0 are available.
  int rows() const { return rows_; }

  struct Tile {
    const std::uint8_t* cells = nullptr;  // null: not read
    bool uniform = false;
  };
  Tile tile(int level, int tile_x, int tile_y) {
    Slot& slot = slots_[std::size_t((level & 3) << 6 | (tile_y & 7) << 3 | (tile_x & 7))];
    if (slot.level != level || slot.x != tile_x || slot.y != tile_y) {
      auto found = cells_.tile(level, tile_x, tile_y);
      slot = {level, tile_x, tile_y, found ? std::move(*found) : grids::GridTile{}};
    }
    return {slot.tile.cells.get(), slot.tile.uniform};
  }
  /// Null: not read. Precondition: inside the level.
  const std::uint8_t* at(int level, int u, int v) {
    const Tile found = tile(level, u >> kEdgeBits, v >> kEdgeBits);
    return found.cells ? found.cells + (((v & (kEdge - 1)) << kEdgeBits) | (u & (kEdge - 1))) : nullptr;
  }

 private:
  struct Slot {
    int level = -1, x = 0, y = 0;
    grids::GridTile tile;
  };
  const grids::GridPyramid& cells_;
  bool complete_;
  int rows_;
  std::array<Slot, 256> slots_;
};

/// The touched cell with the highest rank (of equal ones the greatest byte).
/// A cell of a coarser level is the highest of the cells in it. So if it lies completely inside the pixel it
/// stands for all of them, and if only partly, its cells only matter if it is higher than the best so far.
class HighestTouched {
 public:
  HighestTouched(const grids::GridPyramid& cells, TileReach& reach, const PixelOnCells& square);
  /// `centre`: of the pixel, in cells. False if nothing has been read there.
  bool operator()(const Eigen::Vector2d& centre, std::uint8_t& out);

 private:
  struct Box {
    int level, u, v;
  };
  void look(const Eigen::Vector2d& centre, const Box& box);

  const std::array<std::uint8_t, 256>& order_;
  TileReach& reach_;
  const PixelOnCells& square_;
  int start_;                          // the level to look at first
  std::vector<int> widths_, heights_;  // of the levels
  std::vector<Box> partly_;
  int best_ = -1;
  std::uint8_t best_byte_ = 0;
};

/// The mean of the touched known cells, weighted by their area inside the pixel. Unknown if less than half
/// the area is known.
class MeanTouched {
 public:
  MeanTouched(const grids::GridPyramid& cells, TileReach& reach, const PixelOnCells& square);
  /// As above. `is_known` says whether the byte means a known cell, whatever it would mean by itself.
  bool operator()(const Eigen::Vector2d& centre, std::uint8_t& out, bool& is_known);

 private:
  /// One side of the square between two heights: straight pieces.
  struct Side {
    struct Piece {
      double height, from, to;
    };
    std::array<Piece, 2> pieces;
    int count = 0;
    double least = 0, most = 0;
    /// How much of the column [u, u + 1] is to the left of the side.
    double leftOf(double u) const;
  };
  struct Sums {
    double value = 0, known = 0, read = 0;
  };
  Side sideBetween(const Eigen::Vector2d& bend, double top, double bottom) const;
  void addRow(const Eigen::Vector2d& centre, int v, double top, double bottom, Sums& sums);
  void addCell(int u, int v, double weight, Sums& sums);
  void addRun(int from, int to, int v, double weight, Sums& sums);
  bool oneValueAround(const Eigen::Vector2d& centre, std::uint8_t& out);

  const grids::CellMeaning& meaning_;
  std::uint8_t unknown_;
  TileReach& reach_;
  const PixelOnCells& square_;
  std::array<std::uint32_t, 256> weight_{};  // known << 20 | value
  // Corners relative to the centre: the uppermost, where the sides bend, the lowest.
  Eigen::Vector2d top_, left_, right_, bottom_;
};

}  // namespace mapwright::render
