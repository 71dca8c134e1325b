// Painting: strokes of a round brush, lines, rectangles, polygons, fills, and pieces that are copied and
// pasted. All positions in cells, continuous: (0, 0) is the outer corner of the first cell of the top row,
// rows run down. One thread.
#pragma once

#include <atomic>
#include <optional>
#include <span>
#include <vector>

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

/// The maximum size of a copy in cells.
inline constexpr std::int64_t kMostClippedCells = std::int64_t(1) << 28;

struct Clip {
  int width = 0, height = 0;
  std::vector<std::uint8_t> cells;  // row-major, in the code of its grid
  grids::CellCode code = grids::CellCode::Gray;
};

/// nullopt: entirely outside the picture, or larger than kMostClippedCells.
std::optional<Clip> copyCells(Canvas& canvas, const CellRect& rect);
/// Pastes it with its upper left cell at (left, top); parts outside the picture are dropped. A clip with
/// another code is pasted as free, occupied and unknown.
void putClip(Canvas& canvas, const Clip& clip, int left, int top);

/// The maximum number of tiles for a fill: 32,768 x 32,768 cells.
inline constexpr std::size_t kMostFilledTiles = 16'384;

/// Paints the cell and all of its kind (free, occupied, unknown) that are connected to it by edges. False: it
/// would need more than kMostFilledTiles or was cancelled; the canvas is then unchanged. Does nothing outside
/// the picture.
/// Works tile by tile on rows of bits: filling a whole map costs little more than reading it.
bool floodFill(Canvas& canvas, int column, int row, const Ink& ink,
               const std::atomic<bool>* cancelled = nullptr);

}  // namespace mapwright::picture
