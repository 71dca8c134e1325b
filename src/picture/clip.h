// A piece of a grid, copied to be put elsewhere. Values; any thread.
#pragma once

#include <optional>
#include <vector>

#include "picture/canvas.h"

namespace mapwright::picture {

/// The largest piece that is copied: cells.
inline constexpr std::int64_t kMostClippedCells = std::int64_t(1) << 28;

struct Clip {
  int width = 0, height = 0;
  std::vector<std::uint8_t> cells;  // row-major, in the code of the grid that it is of
  grids::CellCode code = grids::CellCode::Gray;
};

/// nullopt: nothing of it is in the picture, or it is larger than kMostClippedCells.
std::optional<Clip> copyCells(Canvas& canvas, const CellRect& rect);
/// Its upper left cell goes to (left, top); what would lie outside of the picture is left out. A clip of
/// another code is put as free, occupied and unknown.
void putClip(Canvas& canvas, const Clip& clip, int left, int top);

}  // namespace mapwright::picture
