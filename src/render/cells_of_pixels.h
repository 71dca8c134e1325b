// Maps the pixels of a view to the cells of a grid. Private to sampling.
#pragma once

#include <cmath>

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

}  // namespace mapwright::render
