// Flood fill. One thread.
#pragma once

#include <atomic>

#include "picture/canvas.h"

namespace mapwright::picture {

/// The maximum number of tiles for a fill: 32,768 x 32,768 cells.
inline constexpr std::size_t kMostFilledTiles = 16'384;

/// Paints the cell and all of its kind (free, occupied, unknown) that are connected to it by edges. False: it
/// would need more than kMostFilledTiles or was cancelled; the canvas is then unchanged. Does nothing outside
/// the picture.
/// Works tile by tile on rows of bits: filling a whole map costs little more than reading it.
bool floodFill(Canvas& canvas, int column, int row, const Ink& ink,
               const std::atomic<bool>* cancelled = nullptr);

}  // namespace mapwright::picture
