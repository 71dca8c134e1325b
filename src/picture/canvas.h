// What to paint with, and cells that are edited on top of an unchanged grid; the result is a patch. One
// thread.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "grids/grid_pyramid.h"
#include "grids/reduce_grid.h"
#include "picture/edited_grid.h"

namespace mapwright::picture {

enum class Kind : std::uint8_t { Free, Occupied, Unknown };
inline constexpr int kKinds = 3;

/// The kind of every byte of a code. Occupied: 50 % or more.
std::array<Kind, 256> kindsOf(grids::CellCode code);
/// The byte to paint a kind with; nullopt: the code has none (unknown in a picture where every gray is a
/// value).
std::optional<std::uint8_t> byteOf(Kind kind, grids::CellCode code);

/// The first byte among the cells of a grid that is not one of `held`; nullopt: there is none, or it was
/// cancelled.
std::optional<std::uint8_t> firstOther(const grids::GridPyramid& cells, const std::array<bool, 256>& held,
                                       const std::atomic<bool>& cancelled);

/// A byte, or the cells of another grid of the same size and code at the same positions (to revert changes).
struct Ink {
  std::uint8_t byte = 0;
  std::shared_ptr<const grids::GridPyramid> from = {};
};

/// Costs depend on what is touched: tiles are read on demand and copied when a cell changes.
class Canvas {
 public:
  /// `grid` must not change, and must outlive this, until take() has been called.
  explicit Canvas(const EditedGrid& grid);

  CellRect all() const { return grid_.all(); }
  grids::CellCode code() const { return grid_.code(); }
  /// Row-major cells of a tile as they are now; unknown beyond the edge of the picture. Valid until the tile
  /// is written to.
  const std::uint8_t* read(int tile_x, int tile_y);
  /// Columns `from` to `to` (exclusive) of row `row`; parts outside the picture are ignored.
  void paintRow(int row, int from, int to, const Ink& ink);
  /// The same, with a byte for each cell.
  void putRow(int row, int from, int to, const std::uint8_t* bytes);
  /// The cells as they are now; those outside the picture are left out.
  void getRow(int row, int from, int to, std::uint8_t* bytes);
  /// `within`: the cells of that tile, in its own coordinates, that may change. The caller may write to the
  /// whole tile.
  std::uint8_t* write(int tile_x, int tile_y, const CellRect& within);

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
  template <typename Visit>
  void eachPiece(int row, int from, int to, Visit visit);
  TileState stateOf(std::shared_ptr<std::uint8_t[]> cells);
  struct Changed {
    TileKey key;
    const std::uint8_t* cells;
    CellRect dirty;
  };
  std::vector<Changed> reduced(const std::vector<Changed>& finer, Patch& patch);
  std::shared_ptr<std::uint8_t[]> copyOf(const TileKey& key) const;

  const EditedGrid& grid_;
  grids::GridReducer reducer_;
  std::unordered_map<Key, Sheet> sheets_;
  Key last_key_ = 0;
  Sheet* last_ = nullptr;
  CellRect touched_;                                              // bounds of everything written
  std::array<std::shared_ptr<const std::uint8_t>, 256> uniform_;  // one buffer for each byte
};

}  // namespace mapwright::picture
