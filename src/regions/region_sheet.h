// Cells that came in pieces, on one lattice of cells: a pyramid that holds tiles only where something came.
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

/// The byte of a cell that has not been fetched. Robots that send it as a cell mean "unknown": it comes in as
/// grids::kUnknownOccupancy.
inline constexpr std::uint8_t kNotFetched = 0x80;
inline constexpr std::size_t kSheetTileBytes =
    std::size_t(grids::GridPyramid::kTileEdge) * grids::GridPyramid::kTileEdge;

/// As large as a grid may be, around the first piece: what lies farther away needs another sheet. Looks like
/// any other pyramid of occupancy. One thread changes it, any thread looks; tiles that have been handed out
/// never change.
class RegionSheet final : public grids::GridPyramid {
 public:
  /// Sheets begin and end at whole multiples of so many cells, counted from the lattice's own zero, so that
  /// squares of that many cells are whole tiles.
  static constexpr int kStep = 1024;

  /// `piece`: one that is usable (map::whyUnusable) and has cells; its turn is finite.
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

  /// Where the sheet lies; whether anything can be drawn of it says map::whyUnusable.
  const map::GridReference& reference() const { return reference_; }
  /// The zero of the lattice of cells nearest to that of the world, in the world.
  const Eigen::Vector2d& zero() const { return zero_; }
  /// `piece` is on this lattice of cells and within the sheet.
  bool holds(const map::GridReference& piece) const;
  /// Writes all cells of `piece`, which it holds; row 0 is the lowest. As many cells as it says.
  void put(const map::GridReference& piece, const std::vector<std::int8_t>& cells);
  /// Forgets the cells whose middle lies in `rect`, or under `piece`. True when there were any.
  bool forget(const geometry::WorldRect& rect);
  bool forgetUnder(const map::GridReference& piece);
  /// There is a cell whose middle lies in `rect`.
  bool holdsAnyOf(const geometry::WorldRect& rect) const;
  /// Nothing is left.
  bool empty() const;
  /// Bounds in the world of all tiles that hold something.
  geometry::WorldRect bounds() const;

 private:
  struct Place {
    int level, x, y;
    bool operator==(const Place&) const = default;
  };
  struct PlaceHash {
    std::size_t operator()(const Place& place) const noexcept;
  };
  struct CellBox {
    int left, top, right, bottom;  // inclusive
    bool operator==(const CellBox&) const = default;
  };
  using Cells = std::shared_ptr<const std::uint8_t>;
  using Tiles = std::unordered_map<Place, Cells, PlaceHash>;
  /// Where the lower left cell of `piece` lies: column, row from below.
  Eigen::Vector2d cornerOf(const map::GridReference& piece) const;
  std::optional<CellBox> boxAround(const geometry::WorldRect& rect) const;
  /// Forgets cells of `box` for which `inside` says so, given the middle of each in the world.
  template <typename Inside>
  bool forgetWhere(const CellBox& box, Inside inside);
  std::shared_ptr<std::uint8_t> copyOf(const Place& place) const;
  /// Takes over tiles of level 0 (null: nothing is left of it); those of coarser levels are made when they
  /// are looked at, by who looks.
  void take(std::vector<std::pair<Place, Cells>> changed);
  Cells made(const Place& place) const;
  Cells reduced(const Place& place) const;

  grids::GridReducer reducer_;
  map::GridReference reference_;
  Eigen::Vector2d zero_{0, 0};
  int levels_ = 1;
  mutable std::mutex mutex_;
  // Written under the lock: places by the one thread that changes, tiles of coarser levels that are null for
  // not made yet by those that look, too.
  mutable Tiles tiles_;
  std::uint64_t changes_ = 0;
};

}  // namespace mapwright::regions
