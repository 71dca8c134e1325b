// Painting: strokes of a round brush, lines, rectangles, polygons. All positions in cells, continuous: (0, 0)
// is the outer corner of the first cell of the top row, rows run down. One thread.
#pragma once

#include <span>

#include <Eigen/Core>

#include "picture/canvas.h"

namespace mapwright::picture {

inline constexpr int kWidestBrush = 1'000;

/// A round brush of a whole number of cells across, 1 .. kWidestBrush.
struct Brush {
  int across = 1;
  Ink ink;
};

/// The centre of a brush held at `at`: the centre of a cell if its width is odd, otherwise a corner of cells,
/// so that a width of one covers one cell.
Eigen::Vector2d brushCentre(const Eigen::Vector2d& at, int across);

/// Paints the cells whose centres are within half a brush width of the line from `from` to `to`.
void drawLine(Canvas& canvas, const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Brush& brush);
/// All cells between the cells of two corners, inclusive.
CellRect rectangleOf(const Eigen::Vector2d& corner, const Eigen::Vector2d& opposite);
void drawRectangle(Canvas& canvas, const CellRect& rect, const Ink& ink);
/// Paints the cells whose centres are inside; self-intersections follow the even-odd rule.
void drawPolygon(Canvas& canvas, std::span<const Eigen::Vector2d> corners, const Ink& ink);

/// A stroke in progress: every step is applied to the grid at once and costs only what it touches.
class Stroke {
 public:
  /// `grid` must outlive this, and must not be changed by others meanwhile.
  Stroke(EditedGrid& grid, Brush brush) : grid_(grid), brush_(std::move(brush)) {}
  /// Continues the stroke; the first step is a dot. Returns what may have changed.
  CellRect to(const Eigen::Vector2d& at);
  /// The whole stroke as one change, which is already applied to the grid.
  Patch finish() { return std::move(patch_); }
  const Patch& soFar() const { return patch_; }

 private:
  EditedGrid& grid_;
  Brush brush_;
  std::optional<Eigen::Vector2d> last_;
  Patch patch_;
};

}  // namespace mapwright::picture
