// A pyramid during and after reading, or from a side-car file. Private to this room.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "grids/grid_pyramid.h"
#include "grids/reduce_grid.h"
#include "grids/tile_store.h"

namespace mapwright::grids {

/// Whose source may have ended before its last row.
class MayEndEarly {
 public:
  virtual ~MayEndEarly() = default;
  /// Rows of level 0 that never came, and are unknown.
  virtual int missingRows() const = 0;
};

/// Every level has at most one unfinished band of tiles, as plain cells. When a band is full its tiles go to
/// the store. One thread adds rows, any thread reads.
class GrowingPyramid final : public GridPyramid, public MayEndEarly {
 public:
  using Band = std::shared_ptr<std::uint8_t[]>;

  GrowingPyramid(int width, int height, CellCode code, Reduction reduction, const GridReducer& reducer,
                 std::shared_ptr<TileCache> unpacked);
  ~GrowingPyramid() override;

  int width() const override { return width_; }
  int height() const override { return height_; }
  int levels() const override { return int(store_.levels().size()); }
  CellCode code() const override { return code_; }
  Reduction reduction() const override { return reduction_; }
  const std::array<std::uint8_t, 256>& order() const override { return reducer_.order(); }
  std::optional<GridTile> tile(int level, int tile_x, int tile_y) const override;
  int rowsReady() const override { return rows_ready_.load(std::memory_order_acquire); }
  int missingRows() const override { return rows_missing_.load(std::memory_order_acquire); }
  std::size_t bytes() const override;

  /// Bytes per row of a band of `level`: whole tiles.
  std::size_t stride(int level) const;
  /// A buffer for a band of level 0; cells to the right of the picture are unknown.
  Band newBand();
  /// Adds the rows `from` .. `to` (exclusive; a multiple of 2 unless they end the picture) of level 0 in
  /// `band`, which contains the tile row of `from`: reduces and stores them and makes them visible.
  void addRows(const Band& band, int from, int to);
  /// Missing rows become unknown.
  void finish();
  /// All tiles are in the store.
  void markComplete();
  TileStore& store() { return store_; }
  const TileStore& store() const { return store_; }

 private:
  class BandPool;
  struct LiveBand {
    Band cells;  // null: nothing of it yet
    int tile_row = 0;
    int rows = 0;  // of the band, filled so far
  };
  void advance(int level, const Band& band, int from, int to);
  Band bandAt(int level, int row);
  void settle(int level, const Band& band, int from, int to);
  void reduceInto(const Band& coarse, int level, int row, const Band& band);
  void keepTiles(int level, const Band& band, int tile_row, int rows);
  std::optional<GridTile> liveTile(int level, int tile_x, int tile_y) const;
  Band padded(BandPool& pool, int level);

  int width_, height_;
  CellCode code_;
  Reduction reduction_;
  GridReducer reducer_;
  TileStore store_;
  std::vector<std::unique_ptr<BandPool>> pools_;  // by level; empty once finished
  std::vector<int> rows_;                         // by level: how many came
  mutable std::mutex live_mutex_;
  std::vector<LiveBand> live_;  // by level
  std::atomic<std::size_t> band_bytes_{0};
  std::atomic<int> rows_ready_{0}, rows_missing_{0};
};

}  // namespace mapwright::grids
