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

/// Where a brush stands that is held at `at`: the middle of a cell when it is an odd number of cells across,
/// else the corner between four, so that one cell is one cell.
Eigen::Vector2d brushCentre(const Eigen::Vector2d& at, int across);

/// The cells whose centres are within half a brush of the way from `from` to `to`.
void drawLine(Canvas& canvas, const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Brush& brush);
/// All cells between the cells of two corners, these included.
CellRect rectangleOf(const Eigen::Vector2d& corner, const Eigen::Vector2d& opposite);
void drawRectangle(Canvas& canvas, const CellRect& rect, const Ink& ink);
/// The cells whose centres are inside; where it crosses itself, by the even-odd rule.
void drawPolygon(Canvas& canvas, std::span<const Eigen::Vector2d> corners, const Ink& ink);

/// A stroke while it is drawn: every step is in the grid at once and costs what it touches.
class Stroke {
 public:
  /// `grid` must outlive this, and nobody else may change it meanwhile.
  Stroke(EditedGrid& grid, Brush brush) : grid_(grid), brush_(std::move(brush)) {}
  /// Goes on to there; the first step is a dot. What may have changed.
  CellRect to(const Eigen::Vector2d& at);
  /// All of it as one change, which the grid has already.
  Patch finish() { return std::move(patch_); }
  const Patch& soFar() const { return patch_; }

 private:
  EditedGrid& grid_;
  Brush brush_;
  std::optional<Eigen::Vector2d> last_;
  Patch patch_;
};

}  // namespace mapwright::picture
