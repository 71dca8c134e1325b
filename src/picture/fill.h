// Flood fill. One thread.
#pragma once

#include <atomic>

#include "picture/canvas.h"

namespace mapwright::picture {

/// The most tiles that a fill may reach: 32,768 x 32,768 cells.
inline constexpr std::size_t kMostFilledTiles = 16'384;

/// Paints the cell and all of its kind (free, occupied, unknown) that are reached from it over edges of cells
/// of that kind. False: it would reach more than kMostFilledTiles or was cancelled, and the canvas is as it
/// was. Outside of the picture there is nothing to fill.
///
/// Tile by tile, each as rows of bits: a whole map costs little more than looking at it.
bool floodFill(Canvas& canvas, int column, int row, const Ink& ink,
               const std::atomic<bool>* cancelled = nullptr);

}  // namespace mapwright::picture
