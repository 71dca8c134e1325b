#include "grids/growing_pyramid.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "grids/rows_missing.h"

namespace mapwright::grids {

/// Reusable buffers for bands of rows. A buffer returns to the pool when its last owner releases it, even if
/// the pool is gone. Any thread.
class GrowingPyramid::BandPool {
 public:
  explicit BandPool(std::size_t buffer_bytes);
  ~BandPool();
  /// Not initialised.
  std::shared_ptr<std::uint8_t[]> take();
  std::size_t bytes() const;  // allocated in total, in use or not

 private:
  struct Shelf;
  std::shared_ptr<Shelf> shelf_;
};

struct GrowingPyramid::BandPool::Shelf {
  std::size_t buffer_bytes;
  std::mutex mutex;
  std::vector<std::unique_ptr<std::uint8_t[]>> idle;
  std::atomic<std::size_t> buffers{0};
  bool closed = false;  // buffers are no longer taken back
};

GrowingPyramid::BandPool::BandPool(std::size_t buffer_bytes) : shelf_(std::make_shared<Shelf>()) {
  shelf_->buffer_bytes = buffer_bytes;
}

GrowingPyramid::BandPool::~BandPool() {
  const std::lock_guard lock(shelf_->mutex);
  shelf_->closed = true;
  shelf_->buffers -= shelf_->idle.size();
  shelf_->idle.clear();
}

std::shared_ptr<std::uint8_t[]> GrowingPyramid::BandPool::take() {
  std::unique_ptr<std::uint8_t[]> buffer;
  {
    const std::lock_guard lock(shelf_->mutex);
    if (!shelf_->idle.empty()) {
      buffer = std::move(shelf_->idle.back());
      shelf_->idle.pop_back();
    }
  }
  if (buffer == nullptr) {
    buffer = std::make_unique_for_overwrite<std::uint8_t[]>(shelf_->buffer_bytes);
    ++shelf_->buffers;
  }
  const auto give_back = [shelf = shelf_](std::uint8_t* bytes) {
    std::unique_ptr<std::uint8_t[]> returned(bytes);
    const std::lock_guard lock(shelf->mutex);
    if (shelf->closed) {
      --shelf->buffers;
    } else {
      shelf->idle.push_back(std::move(returned));
    }
  };
  return std::shared_ptr<std::uint8_t[]>(buffer.release(), give_back);
}

std::size_t GrowingPyramid::BandPool::bytes() const { return shelf_->buffers * shelf_->buffer_bytes; }

GrowingPyramid::GrowingPyramid(int width, int height, CellCode code, Reduction reduction,
                               const GridReducer& reducer, std::shared_ptr<TileCache> unpacked)
    : width_(width),
      height_(height),
      code_(code),
      reduction_(reduction),
      reducer_(reducer),
      store_(width, height, code, std::move(unpacked)),
      rows_(store_.levels().size()),
      live_(store_.levels().size()) {
  for (int level = 0; level < levels(); ++level) {
    pools_.push_back(std::make_unique<BandPool>(stride(level) * GridPyramid::kTileEdge));
  }
}

GrowingPyramid::~GrowingPyramid() = default;

std::size_t GrowingPyramid::stride(int level) const {
  return std::size_t(store_.levels()[std::size_t(level)].tiles_x) * GridPyramid::kTileEdge;
}

GrowingPyramid::Band GrowingPyramid::newBand() { return padded(*pools_[0], 0); }

GrowingPyramid::Band GrowingPyramid::padded(BandPool& pool, int level) {
  Band band = pool.take();
  const std::size_t row_bytes = stride(level);
  const std::size_t cells = std::size_t(levelWidth(level));
  if (cells < row_bytes) {
    const int rows = std::min(GridPyramid::kTileEdge, levelHeight(level));
    for (int row = 0; row < rows; ++row) {
      std::memset(band.get() + std::size_t(row) * row_bytes + cells, store_.unknown(), row_bytes - cells);
    }
  }
  return band;
}

GrowingPyramid::Band GrowingPyramid::bandAt(int level, int row) {
  {
    const std::lock_guard lock(live_mutex_);
    const LiveBand& live = live_[std::size_t(level)];
    if (live.cells != nullptr && live.tile_row == row / GridPyramid::kTileEdge) return live.cells;
  }
  return padded(*pools_[std::size_t(level)], level);
}

void GrowingPyramid::addRows(const Band& band, int from, int to) {
  advance(0, band, from, to);
  std::size_t held = 0;
  for (const auto& pool : pools_) held += pool->bytes();
  band_bytes_.store(held, std::memory_order_relaxed);
  rows_ready_.store(to, std::memory_order_release);
}

void GrowingPyramid::settle(int level, const Band& band, int from, int to) {
  const int tile_row = from / GridPyramid::kTileEdge;
  rows_[std::size_t(level)] = to;
  const bool full = to == (tile_row + 1) * GridPyramid::kTileEdge || to == levelHeight(level);
  if (full) keepTiles(level, band, tile_row, to - tile_row * GridPyramid::kTileEdge);
  const std::lock_guard lock(live_mutex_);
  live_[std::size_t(level)] =
      full ? LiveBand{} : LiveBand{band, tile_row, to - tile_row * GridPyramid::kTileEdge};
}

void GrowingPyramid::reduceInto(const Band& coarse, int level, int row, const Band& band) {
  const int top = 2 * row / GridPyramid::kTileEdge * GridPyramid::kTileEdge;
  const std::uint8_t* upper = band.get() + std::size_t(2 * row - top) * stride(level);
  // An odd last row of the picture is its own partner.
  const std::uint8_t* lower = 2 * row + 1 < levelHeight(level) ? upper + stride(level) : upper;
  reducer_.reduceRow(upper, lower, std::size_t(levelWidth(level)),
                     coarse.get() + std::size_t(row % GridPyramid::kTileEdge) * stride(level + 1));
}

void GrowingPyramid::advance(int level, const Band& band, int from, int to) {
  settle(level, band, from, to);
  if (level + 1 == levels()) return;

  const int coarse_from = from / 2;
  const int coarse_to = to == levelHeight(level) ? (to + 1) / 2 : to / 2;
  if (coarse_from == coarse_to) return;
  const Band coarse = bandAt(level + 1, coarse_from);
  for (int row = coarse_from; row < coarse_to; ++row) reduceInto(coarse, level, row, band);
  advance(level + 1, coarse, coarse_from, coarse_to);
}

void GrowingPyramid::keepTiles(int level, const Band& band, int tile_row, int rows) {
  const std::size_t row_bytes = stride(level);
  std::array<std::uint8_t, TileStore::kTileCells> tile;
  const int tiles = store_.levels()[std::size_t(level)].tiles_x;
  for (int tile_x = 0; tile_x < tiles; ++tile_x) {
    const std::uint8_t* from = band.get() + std::size_t(tile_x) * GridPyramid::kTileEdge;
    for (int row = 0; row < rows; ++row) {
      std::memcpy(tile.data() + std::size_t(row) * GridPyramid::kTileEdge,
                  from + std::size_t(row) * row_bytes, GridPyramid::kTileEdge);
    }
    std::memset(tile.data() + std::size_t(rows) * GridPyramid::kTileEdge, store_.unknown(),
                std::size_t(GridPyramid::kTileEdge - rows) * GridPyramid::kTileEdge);
    store_.put(level, tile_x, tile_row, tile.data());
  }
}

void GrowingPyramid::finish() {
  rows_missing_.store(height_ - rows_[0], std::memory_order_release);
  for (int level = 0; level < levels(); ++level) {
    const int height = levelHeight(level);
    const int row = rows_[std::size_t(level)];
    if (row == height) continue;
    const int begun = row % GridPyramid::kTileEdge;  // rows of the unfinished band
    if (begun > 0) {
      const Band band = bandAt(level, row);
      const int end = std::min(height, row - begun + GridPyramid::kTileEdge);
      std::memset(band.get() + std::size_t(begun) * stride(level), store_.unknown(),
                  std::size_t(end - row) * stride(level));
      if (row % 2 != 0 && level + 1 < levels()) {
        const Band coarse = bandAt(level + 1, row / 2);
        reduceInto(coarse, level, row / 2, band);
        advance(level + 1, coarse, row / 2, row / 2 + 1);
      }
      settle(level, band, row, end);
    }
    const TileLevel& tiles = store_.levels()[std::size_t(level)];
    for (int tile_y = (row + GridPyramid::kTileEdge - 1) / GridPyramid::kTileEdge; tile_y < tiles.tiles_y;
         ++tile_y) {
      for (int tile_x = 0; tile_x < tiles.tiles_x; ++tile_x) {
        store_.putUniform(level, tile_x, tile_y, store_.unknown());
      }
    }
  }
  markComplete();
}

void GrowingPyramid::markComplete() {
  pools_.clear();
  band_bytes_.store(0, std::memory_order_relaxed);
  rows_ready_.store(height_, std::memory_order_release);
}

int rowsMissing(const GridPyramid& cells) {
  const auto* const read = dynamic_cast<const MayEndEarly*>(&cells);
  return read ? read->missingRows() : 0;
}

std::optional<GridTile> GrowingPyramid::tile(int level, int tile_x, int tile_y) const {
  if (auto kept = store_.get(level, tile_x, tile_y)) return kept;
  if (auto live = liveTile(level, tile_x, tile_y)) return live;
  // The band may have been stored between the two checks.
  return store_.get(level, tile_x, tile_y);
}

std::optional<GridTile> GrowingPyramid::liveTile(int level, int tile_x, int tile_y) const {
  if (level < 0 || level >= levels() || tile_x < 0 || tile_x >= store_.levels()[std::size_t(level)].tiles_x) {
    return std::nullopt;
  }
  LiveBand live;
  {
    const std::lock_guard lock(live_mutex_);
    live = live_[std::size_t(level)];
  }
  if (live.cells == nullptr || live.tile_row != tile_y) return std::nullopt;
  // Visible rows are never written again, so they are read without the lock.
  auto cells = std::shared_ptr<std::uint8_t[]>(new std::uint8_t[TileStore::kTileCells]);
  const std::uint8_t* from = live.cells.get() + std::size_t(tile_x) * GridPyramid::kTileEdge;
  for (int row = 0; row < live.rows; ++row) {
    std::memcpy(cells.get() + std::size_t(row) * GridPyramid::kTileEdge,
                from + std::size_t(row) * stride(level), GridPyramid::kTileEdge);
  }
  std::memset(cells.get() + std::size_t(live.rows) * GridPyramid::kTileEdge, store_.unknown(),
              std::size_t(GridPyramid::kTileEdge - live.rows) * GridPyramid::kTileEdge);
  return GridTile{std::shared_ptr<const std::uint8_t>(cells, cells.get()), false, false};
}

std::size_t GrowingPyramid::bytes() const {
  return store_.bytes() + band_bytes_.load(std::memory_order_relaxed);
}

}  // namespace mapwright::grids
