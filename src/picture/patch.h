// A change of an edited grid: the touched tiles, before and after. Value; any thread.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <unordered_map>

#include "picture/cell_rect.h"

namespace mapwright::picture {

/// Of a pyramid: level 0 is exact.
struct TilePlace {
  int level = 0, x = 0, y = 0;
  auto operator<=>(const TilePlace&) const = default;
};

/// kTileEdge x kTileEdge bytes as in grids::GridTile, shared and immutable; null: as in the original picture.
struct TileState {
  std::shared_ptr<const std::uint8_t> cells;
  bool uniform = false;
  bool operator==(const TileState& other) const { return cells == other.cells; }
};

struct TileChange {
  TileState before, after;
};

/// Tiles of all levels, so that undo and redo only swap pointers.
struct Patch {
  std::map<TilePlace, TileChange> tiles;
  bool finest_only = false;  // coarser levels have to be rebuilt first (withCoarserLevels)
  CellRect cells;            // of level 0: nothing outside changes

  bool empty() const { return tiles.empty(); }
  /// Combines both, `later` after this one.
  void append(const Patch& later);
  /// Upper bound of the memory it holds in bytes: tiles may be shared.
  std::size_t bytes() const;
};

/// The memory that several patches hold together in bytes: a tile shared by two counts once.
class PatchMemory {
 public:
  void add(const Patch& patch);
  void remove(const Patch& patch);
  std::size_t bytes() const;

 private:
  std::unordered_map<const std::uint8_t*, int> held_;
};

}  // namespace mapwright::picture
