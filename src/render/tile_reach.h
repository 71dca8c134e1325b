// Access to the tiles of a pyramid while walking over its cells. Private to sampling; one thread.
#pragma once

#include <array>
#include <cstdint>

#include "grids/grid_pyramid.h"

namespace mapwright::render {

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

}  // namespace mapwright::render
