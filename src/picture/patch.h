// A change of an edited grid as the tiles that it touches, before and after. Value; any thread.
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

/// kTileEdge x kTileEdge bytes as in grids::GridTile, shared and never written to; null: as in the picture
/// that the grid was made of.
struct TileState {
  std::shared_ptr<const std::uint8_t> cells;
  bool uniform = false;
  bool operator==(const TileState& other) const { return cells == other.cells; }
};

struct TileChange {
  TileState before, after;
};

/// Tiles of all levels, so that undoing and redoing exchange pointers and reckon nothing.
struct Patch {
  std::map<TilePlace, TileChange> tiles;
  bool finest_only = false;  // coarser levels are to be made anew first (withCoarserLevels)
  CellRect cells;            // of level 0: nothing outside is changed

  bool empty() const { return tiles.empty(); }
  /// What both do together, `later` after this one.
  void append(const Patch& later);
  /// What it holds on to at most, in bytes: tiles may be shared with others.
  std::size_t bytes() const;
};

/// What several patches hold on to together, in bytes: what one leaves is what the next one finds.
class PatchMemory {
 public:
  void add(const Patch& patch);
  void remove(const Patch& patch);
  std::size_t bytes() const;

 private:
  std::unordered_map<const std::uint8_t*, int> held_;
};

}  // namespace mapwright::picture
