// Cells received in pieces on one lattice: a pyramid that only has tiles where something arrived.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "grids/grid_pyramid.h"
#include "grids/reduce_grid.h"
#include "map/grid_reference.h"

namespace mapwright::regions {

/// The byte of a cell that has not been fetched. Robots that send it mean "unknown": it is stored as
/// grids::kUnknownOccupancy.
inline constexpr std::uint8_t kNotFetched = 0x80;
inline constexpr int kTile = grids::GridPyramid::kTileEdge;
inline constexpr std::size_t kSheetTileBytes = std::size_t(kTile) * kTile;

/// As large as a grid may be, around the first piece: anything farther away needs another sheet. Acts like
/// any other occupancy pyramid. One thread changes it, any thread reads; tiles handed out never change.
class RegionSheet final : public grids::GridPyramid {
 public:
  /// Sheets start and end at multiples of this many cells, counted from the lattice's origin, so that squares
  /// of this size are whole tiles.
  static constexpr int kStep = 1024;

  /// `piece` must be valid (map::unusableReason), with cells and a finite rotation.
  explicit RegionSheet(const map::GridReference& piece);

  int width() const override { return reference_.width; }
  int height() const override { return reference_.height; }
  int levels() const override { return levels_; }
  grids::CellCode code() const override { return grids::CellCode::Occupancy; }
  grids::Reduction reduction() const override { return grids::Reduction::OccupiedWins; }
  const std::array<std::uint8_t, 256>& order() const override { return reducer_.order(); }
  std::optional<grids::GridTile> tile(int level, int tile_x, int tile_y) const override;
  int rowsReady() const override { return reference_.height; }
  std::size_t bytes() const override;

  /// The position of the sheet; map::unusableReason tells whether it can be drawn.
  const map::GridReference& reference() const { return reference_; }
  /// The origin of the cell lattice nearest to the world origin, in world coordinates.
  const Eigen::Vector2d& zero() const { return zero_; }
  /// `piece` is on this lattice and within the sheet.
  bool holds(const map::GridReference& piece) const;
  /// Writes all cells of `piece`, for which holds() must be true; row 0 is the lowest. As many cells as it
  /// says.
  void put(const map::GridReference& piece, const std::vector<std::int8_t>& cells);
  /// Drops the cells whose centre is in `rect`, or under `piece`. True if there were any.
  bool forget(const geometry::WorldRect& rect);
  bool forgetUnder(const map::GridReference& piece);
  /// There is a cell whose centre is in `rect`.
  bool holdsAnyOf(const geometry::WorldRect& rect) const;
  /// Nothing is left.
  bool empty() const;
  /// World bounds of all tiles with content.
  geometry::WorldRect bounds() const;

 private:
  struct TileKey {
    int level, x, y;
    bool operator==(const TileKey&) const = default;
  };
  struct TileKeyHash {
    std::size_t operator()(const TileKey& key) const noexcept;
  };
  struct CellBox {
    int left, top, right, bottom;  // inclusive
    bool operator==(const CellBox&) const = default;
  };
  using Cells = std::shared_ptr<const std::uint8_t>;
  using Tiles = std::unordered_map<TileKey, Cells, TileKeyHash>;
  /// The position of the lower left cell of `piece`: column, row from below.
  Eigen::Vector2d cornerOf(const map::GridReference& piece) const;
  std::optional<CellBox> boxAround(const geometry::WorldRect& rect) const;
  /// Drops the cells of `box` for which `inside`, given the world position of the centre, is true.
  template <typename Inside>
  bool forgetWhere(const CellBox& box, Inside inside);
  std::shared_ptr<std::uint8_t> copyOf(const TileKey& key) const;
  /// Takes over tiles of level 0 (null: nothing left); those of coarser levels are created on demand by the
  /// reader.
  void replaceTiles(std::vector<std::pair<TileKey, Cells>> changed);
  Cells made(const TileKey& key) const;
  Cells reduced(const TileKey& key) const;

  grids::GridReducer reducer_;
  map::GridReference reference_;
  Eigen::Vector2d zero_{0, 0};
  int levels_ = 1;
  mutable std::mutex mutex_;
  // Written under the lock: entries by the changing thread, and missing tiles of coarser levels also by
  // readers.
  mutable Tiles tiles_;
  std::uint64_t changes_ = 0;
};

}  // namespace mapwright::regions
