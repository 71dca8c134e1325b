// Edits cells on top of an unchanged grid; the result is a patch. One thread.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "grids/reduce_grid.h"
#include "picture/edited_grid.h"
#include "picture/paint.h"

namespace mapwright::picture {

/// Costs depend on what is touched: tiles are read on demand and copied when a cell changes.
class Canvas {
 public:
  static constexpr int kEdge = grids::GridPyramid::kTileEdge;
  static constexpr std::size_t kTileCells = std::size_t(kEdge) * kEdge;  // one byte each

  /// `grid` must not change, and must outlive this, until take() has been called.
  explicit Canvas(const EditedGrid& grid);

  CellRect all() const { return grid_.all(); }
  grids::CellCode code() const { return grid_.code(); }
  /// Row-major cells of a tile as they are now; unknown beyond the edge of the picture. Valid until the tile
  /// is written to.
  const std::uint8_t* read(int tile_x, int tile_y);
  bool uniform(int tile_x, int tile_y);
  /// Columns `from` to `to` (exclusive) of row `row`; parts outside the picture are ignored.
  void paintRow(int row, int from, int to, const Ink& ink);
  /// The same, with a byte for each cell.
  void putRow(int row, int from, int to, const std::uint8_t* bytes);
  /// `within`: the cells of that tile, in its own coordinates, that may change. The caller may write to the
  /// whole tile.
  std::uint8_t* write(int tile_x, int tile_y, const CellRect& within);
  /// Bounds of everything written.
  const CellRect& touched() const { return touched_; }
  bool empty() const { return touched_.empty(); }

  /// The changes at all levels. Afterwards the canvas is empty, and its grid may change.
  Patch take();

 private:
  struct Sheet {
    grids::GridTile read;                   // the tile in the grid; cells null: not read yet
    std::shared_ptr<std::uint8_t[]> wrote;  // null: nothing yet
    CellRect dirty;                         // in cells of the tile
  };
  using Key = std::uint64_t;
  static Key keyOf(int tile_x, int tile_y) {
    return std::uint64_t(unsigned(tile_y)) << 32 | unsigned(tile_x);
  }
  Sheet& sheet(int tile_x, int tile_y);
  TileState stateOf(std::shared_ptr<std::uint8_t[]> cells);
  struct Changed {
    TilePlace place;
    const std::uint8_t* cells;
    CellRect dirty;
  };
  std::vector<Changed> reduced(const std::vector<Changed>& finer, Patch& patch);
  std::shared_ptr<std::uint8_t[]> copyOf(const TilePlace& place) const;

  const EditedGrid& grid_;
  grids::GridReducer reducer_;
  std::unordered_map<Key, Sheet> sheets_;
  Key last_key_ = 0;
  Sheet* last_ = nullptr;
  CellRect touched_;
  std::array<std::shared_ptr<const std::uint8_t>, 256> uniform_;  // one buffer for each byte
};

}  // namespace mapwright::picture
