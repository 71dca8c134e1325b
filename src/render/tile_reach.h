// The tiles of a pyramid for somebody who walks over its cells. Private to sampling; one thread.
#pragma once

#include <array>
#include <cstdint>

#include "grids/grid_pyramid.h"

namespace mapwright::render {

/// Keeps the tiles that were used last, so that neighbouring pixels need not ask the pyramid again; bounded,
/// however much a pixel covers. Rows that have not been read yet are not there.
class TileReach {
 public:
  static constexpr int kEdge = grids::GridPyramid::kTileEdge;
  static constexpr int kEdgeBits = 8;
  static_assert(1 << kEdgeBits == kEdge);

  explicit TileReach(const grids::GridPyramid& cells)
      : cells_(cells), complete_(cells.complete()), rows_(cells.rowsReady()) {}

  /// What was complete when this was made has all its levels.
  bool complete() const { return complete_; }
  int width() const { return cells_.width(); }
  /// Rows of level 0 that are there.
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
