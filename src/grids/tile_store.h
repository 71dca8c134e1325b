// The tiles of a pyramid, compressed: in memory, or in a file if there is one. Private to the pyramids.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "grids/grid_pyramid.h"
#include "grids/tile_cache.h"

namespace mapwright::grids {

/// Tile counts of one level.
struct TileLevel {
  int width = 0, height = 0;  // cells
  int tiles_x = 0, tiles_y = 0;
  std::size_t first = 0;  // index of its first tile among all
};
/// All levels of a picture, down to the one that fits into one tile.
std::vector<TileLevel> tileLevels(int width, int height);

/// One thread writes, any thread reads. A tile takes 8 bytes of index; a uniform tile takes nothing else.
class TileStore {
 public:
  static constexpr int kEdge = GridPyramid::kTileEdge;
  static constexpr std::size_t kTileCells = std::size_t(kEdge) * kEdge;
  static constexpr std::size_t kChunk = std::size_t(1) << 20;  // tiles are packed into chunks of this size

  /// `unpacked`: shared with other stores; null = a private one.
  TileStore(int width, int height, CellCode code, std::shared_ptr<TileCache> unpacked);
  ~TileStore();
  TileStore(const TileStore&) = delete;
  TileStore& operator=(const TileStore&) = delete;

  const std::vector<TileLevel>& levels() const { return levels_; }
  std::uint8_t unknown() const { return unknown_; }

  /// `cells`: kTileCells bytes.
  void put(int level, int tile_x, int tile_y, const std::uint8_t* cells);
  void putUniform(int level, int tile_x, int tile_y, std::uint8_t value);
  /// nullopt: not stored yet, or no such tile.
  std::optional<GridTile> get(int level, int tile_x, int tile_y) const;
  GridTile uniform(std::uint8_t value) const;
  std::size_t bytes() const;

  /// Full chunks are written to `fd` from `data_offset` on and leave memory. The store owns `fd`. Call before
  /// put(). `salt` and the position of each tile go into the checksums, so that misplaced tiles are detected.
  void spillTo(int fd, std::int64_t data_offset, std::uint32_t salt);
  /// Writes the last chunk. False if the file could not take everything: the rest stays in memory.
  bool flush();
  int fd() const { return fd_; }
  /// Bytes from the first chunk to the end of the last tile.
  std::uint64_t dataBytes() const;

  /// The index for writing to a file, and the reverse. A restored store reads its tiles from `fd`.
  std::vector<std::uint64_t> index() const;
  /// False if an entry is invalid or points outside `data_bytes`.
  bool restore(const std::vector<std::uint64_t>& index, int fd, std::int64_t data_offset,
               std::uint64_t data_bytes, std::uint32_t salt);

 private:
  using Chunk = std::shared_ptr<std::uint8_t[]>;
  std::optional<std::size_t> numberOf(int level, int tile_x, int tile_y) const;
  std::uint8_t* reserve(std::size_t size, std::uint64_t& offset);
  void retireChunk();
  GridTile unpack(std::size_t number, std::uint64_t entry) const;
  std::uint32_t checksum(std::size_t number, const std::uint8_t* bytes, std::size_t size) const;
  bool readBlob(std::uint64_t offset, std::size_t size, std::uint8_t* out) const;

  std::vector<TileLevel> levels_;
  std::size_t tile_count_ = 0;
  std::uint8_t unknown_;
  std::unique_ptr<std::atomic<std::uint64_t>[]> entries_;

  mutable std::mutex chunks_mutex_;
  std::vector<Chunk> chunks_;  // null: in the file
  std::size_t resident_ = 0;   // chunks in memory
  std::size_t used_ = 0;       // bytes used in the last chunk
  int fd_ = -1;
  std::int64_t data_offset_ = 0;
  std::uint32_t salt_ = 0;
  bool spilling_ = false;

  mutable std::mutex uniform_mutex_;
  mutable std::vector<std::shared_ptr<const std::uint8_t>> uniform_;
  mutable std::size_t uniform_count_ = 0;
  const std::shared_ptr<TileCache> unpacked_;
  const std::uint64_t name_;  // in there
};

}  // namespace mapwright::grids
