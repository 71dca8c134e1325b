// A piece of a grid, copied to be pasted elsewhere. Values; any thread.
#pragma once

#include <optional>
#include <vector>

#include "picture/canvas.h"

namespace mapwright::picture {

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

}  // namespace mapwright::picture
