// World-aligned tiles of the reduced exact picture, and what is computed from them. Pure functions, any
// thread. Private to this room. Why: docs/decisions/0007-the-view-is-drawn-in-tiles.md.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "render/compositor.h"

namespace mapwright::render {

inline constexpr int kTileEdge = 256;  // pixels, of all tiles

/// Tile (x, y) of `level` covers pixels [x, x+1) * kTileEdge by [y, y+1) * kTileEdge of the unrotated raster
/// through the world origin whose pixels are base * 2^level metres wide. Its four parts are (2x, 2y) ..
/// (2x+1, 2y+1) one level down.
struct PyramidKey {
  int level = 0;
  std::int64_t x = 0, y = 0;
  bool operator==(const PyramidKey&) const = default;
};

/// kTileEdge x kTileEdge pixels. Intensities have 8 fraction bits so that repeated halving does not drift.
struct PyramidTile {
  std::vector<std::uint16_t> intensity;  // 256 * (0..255)
  std::vector<std::uint16_t> flags;
  std::size_t bytes() const { return (intensity.size() + flags.size()) * sizeof(std::uint16_t); }
};
using PyramidTilePtr = std::shared_ptr<const PyramidTile>;  // null: nothing observed

PixelGrid gridOf(const PyramidKey& key, double base_m_per_px);

/// The tile for a composition of gridOf(); null if nothing was observed.
PyramidTilePtr pyramidTileOf(const Composition& pixels);
/// Halves four tiles: top left, top right, bottom left, bottom right. 2x2 means, flags united(). Null if all
/// are.
PyramidTilePtr halved(const std::array<PyramidTilePtr, 4>& parts);

/// A rectangle of pyramid tiles of one level.
struct PyramidPatch {
  PyramidKey first;  // top left
  int columns = 0, rows = 0;
  double m_per_px = 0;                // of the level
  std::vector<PyramidTilePtr> tiles;  // row-major
};
/// The tiles of `level` needed for the pixels of `grid`, still empty. Columns and rows are 0 if there are
/// absurdly many.
PyramidPatch patchFor(const PixelGrid& grid, int level, double base_m_per_px);

/// The pixels of `grid`, each the mean of the patch area under it (n x n bilinear samples no further apart
/// than the patch's pixels), flags united(). Empty (width 0) if cancelled.
Composition resampled(const PixelGrid& grid, const PyramidPatch& patch, const std::atomic<bool>& cancelled);

}  // namespace mapwright::render
