// A whole map with edits on top: tiles are copied on write. Why:
// docs/decisions/0015-edits-are-documents-with-drafts.md.
#pragma once

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "grids/grid_pyramid.h"

namespace mapwright::picture {

inline constexpr int kEdge = grids::GridPyramid::kTileEdge;            // of a tile
inline constexpr std::size_t kTileCells = std::size_t(kEdge) * kEdge;  // one byte each

/// A rectangle of cells: columns left .. right and rows top .. bottom, the second of each excluded; rows
/// count from the top.
struct CellRect {
  int left = 0, top = 0, right = 0, bottom = 0;

  bool empty() const { return left >= right || top >= bottom; }
  int width() const { return empty() ? 0 : right - left; }
  int height() const { return empty() ? 0 : bottom - top; }
  std::int64_t area() const { return std::int64_t(width()) * height(); }
  bool contains(int column, int row) const {
    return column >= left && column < right && row >= top && row < bottom;
  }
  CellRect intersected(const CellRect& other) const {
    const CellRect both{std::max(left, other.left), std::max(top, other.top), std::min(right, other.right),
                        std::min(bottom, other.bottom)};
    return both.empty() ? CellRect{} : both;
  }
  CellRect united(const CellRect& other) const {
    if (empty()) return other;
    if (other.empty()) return *this;
    return {std::min(left, other.left), std::min(top, other.top), std::max(right, other.right),
            std::max(bottom, other.bottom)};
  }
  CellRect grown(int cells) const { return {left - cells, top - cells, right + cells, bottom + cells}; }
  CellRect moved(int columns, int rows) const {
    return {left + columns, top + rows, right + columns, bottom + rows};
  }
  bool operator==(const CellRect&) const = default;
};

/// Of a pyramid: level 0 is exact.
struct TileKey {
  int level = 0, x = 0, y = 0;
  auto operator<=>(const TileKey&) const = default;
};

/// kTileCells bytes as in grids::GridTile, shared and immutable; null: as in the original picture.
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
  std::map<TileKey, TileChange> tiles;
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

/// Acts like any other pyramid, with the same code, size and reduction: the edited map is what is drawn,
/// exported and compared. One thread edits it, any thread reads; tiles handed out never change.
class EditedGrid final : public grids::GridPyramid {
 public:
  /// `base`: complete, never null.
  explicit EditedGrid(std::shared_ptr<const grids::GridPyramid> base);

  int width() const override { return base_->width(); }
  int height() const override { return base_->height(); }
  int levels() const override { return base_->levels(); }
  grids::CellCode code() const override { return base_->code(); }
  grids::Reduction reduction() const override { return base_->reduction(); }
  const std::array<std::uint8_t, 256>& order() const override { return base_->order(); }
  std::optional<grids::GridTile> tile(int level, int tile_x, int tile_y) const override;
  int rowsReady() const override { return base_->rowsReady(); }
  std::size_t bytes() const override;
  Fault trouble() const override { return base_->trouble(); }

  const std::shared_ptr<const grids::GridPyramid>& base() const { return base_; }
  CellRect all() const { return {0, 0, width(), height()}; }
  /// A copy of the present state: costs one pointer for each changed tile.
  std::shared_ptr<EditedGrid> snapshot() const;

  /// The changed tile, or one without cells if it is as in the base.
  TileState own(const TileKey& key) const;
  /// The positions on level 0 of which own() has tiles.
  std::vector<TileKey> changedTiles() const;
  /// The patch was made for the present grid (Canvas), or is the next one to undo or redo.
  void apply(const Patch& patch);
  void revert(const Patch& patch);
  /// Changes with every edit.
  std::uint64_t revision() const { return revision_; }

 private:
  struct TileKeyHash {
    std::size_t operator()(const TileKey& key) const noexcept;
  };
  using Tiles = std::unordered_map<TileKey, TileState, TileKeyHash>;
  EditedGrid(std::shared_ptr<const grids::GridPyramid> base, Tiles tiles);
  void exchange(const Patch& patch, TileState TileChange::*side);

  std::shared_ptr<const grids::GridPyramid> base_;
  mutable std::mutex mutex_;
  Tiles tiles_;
  std::uint64_t revision_ = 0;
};

}  // namespace mapwright::picture
