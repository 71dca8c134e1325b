#include "grids/tile_store.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <isa-l/crc.h>
#include <lz4.h>
#include <unistd.h>

#include "disk/read_file.h"

namespace mapwright::grids {

namespace {

// An index entry: kind of tile (2 bits), packed length (17 bits), offset of its blob (45 bits). 0: missing. A
// blob is a checksum of 4 bytes and the packed cells.
enum class Kind : std::uint64_t { Absent, Uniform, Packed, Plain };
constexpr int kOffsetBits = 45, kSizeBits = 17;
constexpr std::size_t kChecksumBytes = 4;

std::uint64_t entryOf(Kind kind, std::uint64_t size, std::uint64_t offset) {
  return std::uint64_t(kind) << (kOffsetBits + kSizeBits) | size << kOffsetBits | offset;
}
Kind kindOf(std::uint64_t entry) { return Kind(entry >> (kOffsetBits + kSizeBits)); }
std::size_t sizeOf(std::uint64_t entry) { return entry >> kOffsetBits & ((1u << kSizeBits) - 1); }
std::uint64_t offsetOf(std::uint64_t entry) { return entry & ((std::uint64_t(1) << kOffsetBits) - 1); }

std::shared_ptr<std::uint8_t[]> uninitialised(std::size_t size) {
  return std::shared_ptr<std::uint8_t[]>(new std::uint8_t[size]);
}

}  // namespace

std::vector<TileLevel> tileLevels(int width, int height) {
  constexpr int kEdge = GridPyramid::kTileEdge;
  std::vector<TileLevel> levels;
  std::size_t first = 0;
  for (;;) {
    const TileLevel level{width, height, (width + kEdge - 1) / kEdge, (height + kEdge - 1) / kEdge, first};
    levels.push_back(level);
    if (width <= kEdge && height <= kEdge) return levels;
    first += std::size_t(level.tiles_x) * std::size_t(level.tiles_y);
    width = (width + 1) / 2;
    height = (height + 1) / 2;
  }
}

TileStore::TileStore(int width, int height, CellCode code, std::shared_ptr<TileCache> unpacked)
    : levels_(tileLevels(width, height)),
      unknown_(unknownByte(code)),
      uniform_(256),
      unpacked_(unpacked ? std::move(unpacked) : std::make_shared<TileCache>()),
      name_(unpacked_->newOwner()) {
  static_assert(kTileCells == TileCache::kTileBytes);
  tile_count_ = levels_.back().first + 1;
  entries_ = std::make_unique<std::atomic<std::uint64_t>[]>(tile_count_);
}

TileStore::~TileStore() {
  unpacked_->forget(name_);
  if (fd_ >= 0) ::close(fd_);
}

std::uint32_t TileStore::checksum(std::size_t number, const std::uint8_t* bytes, std::size_t size) const {
  return crc32_gzip_refl(salt_ ^ std::uint32_t(number * 0x9e3779b1u), bytes, size);
}

std::optional<std::size_t> TileStore::numberOf(int level, int tile_x, int tile_y) const {
  if (level < 0 || std::size_t(level) >= levels_.size()) return std::nullopt;
  const TileLevel& at = levels_[std::size_t(level)];
  if (tile_x < 0 || tile_y < 0 || tile_x >= at.tiles_x || tile_y >= at.tiles_y) return std::nullopt;
  return at.first + std::size_t(tile_y) * std::size_t(at.tiles_x) + std::size_t(tile_x);
}

void TileStore::putUniform(int level, int tile_x, int tile_y, std::uint8_t value) {
  entries_[*numberOf(level, tile_x, tile_y)].store(entryOf(Kind::Uniform, 0, value),
                                                   std::memory_order_release);
}

void TileStore::put(int level, int tile_x, int tile_y, const std::uint8_t* cells) {
  if (std::memcmp(cells, cells + 1, kTileCells - 1) == 0) return putUniform(level, tile_x, tile_y, cells[0]);
  std::array<std::uint8_t, LZ4_COMPRESSBOUND(kTileCells)> packed;
  std::size_t size = std::size_t(LZ4_compress_default(reinterpret_cast<const char*>(cells),
                                                      reinterpret_cast<char*>(packed.data()), int(kTileCells),
                                                      int(packed.size())));
  const bool plain = size == 0 || size >= kTileCells;
  const std::uint8_t* bytes = plain ? cells : packed.data();
  if (plain) size = kTileCells;
  std::uint64_t offset = 0;
  std::uint8_t* out = reserve(kChecksumBytes + size, offset);
  const std::size_t number = *numberOf(level, tile_x, tile_y);
  const std::uint32_t sum = checksum(number, bytes, size);
  std::memcpy(out, &sum, kChecksumBytes);
  std::memcpy(out + kChecksumBytes, bytes, size);
  entries_[number].store(entryOf(plain ? Kind::Plain : Kind::Packed, size, offset),
                         std::memory_order_release);
}

std::uint8_t* TileStore::reserve(std::size_t size, std::uint64_t& offset) {
  if (chunks_.empty() || used_ + size > kChunk) {
    if (!chunks_.empty()) retireChunk();
    const std::lock_guard lock(chunks_mutex_);
    chunks_.push_back(uninitialised(kChunk));
    ++resident_;
    used_ = 0;
  }
  offset = (chunks_.size() - 1) * kChunk + used_;
  std::uint8_t* out = chunks_.back().get() + used_;
  used_ += size;
  return out;
}

void TileStore::retireChunk() {
  if (!spilling_) return;
  const std::size_t number = chunks_.size() - 1;
  if (!disk::writeAt(fd_, {chunks_.back().get(), used_}, std::uint64_t(data_offset_) + number * kChunk)) {
    spilling_ = false;  // the disk is full: from here on everything stays in memory
    return;
  }
  const std::lock_guard lock(chunks_mutex_);
  chunks_[number].reset();
  --resident_;
}

void TileStore::spillTo(int fd, std::int64_t data_offset, std::uint32_t salt) {
  salt_ = salt;
  fd_ = fd;
  data_offset_ = data_offset;
  spilling_ = true;
}

bool TileStore::flush() {
  if (!spilling_) return false;
  if (!chunks_.empty() && chunks_.back() != nullptr) retireChunk();
  return spilling_;
}

std::uint64_t TileStore::dataBytes() const {
  return chunks_.empty() ? 0 : (chunks_.size() - 1) * kChunk + used_;
}

std::vector<std::uint64_t> TileStore::index() const {
  std::vector<std::uint64_t> entries(tile_count_);
  for (std::size_t n = 0; n < tile_count_; ++n) entries[n] = entries_[n].load(std::memory_order_relaxed);
  return entries;
}

bool TileStore::restore(const std::vector<std::uint64_t>& index, int fd, std::int64_t data_offset,
                        std::uint64_t data_bytes, std::uint32_t salt) {
  if (index.size() != tile_count_) return false;
  for (const std::uint64_t entry : index) {
    const Kind kind = kindOf(entry);
    if (kind == Kind::Absent || (kind == Kind::Uniform && offsetOf(entry) > 255)) return false;
    if (kind == Kind::Uniform) continue;
    const std::size_t size = sizeOf(entry);
    if (size == 0 || size > kTileCells || (kind == Kind::Plain && size != kTileCells)) return false;
    const std::uint64_t end = offsetOf(entry) + kChecksumBytes + size;
    if (offsetOf(entry) % kChunk + kChecksumBytes + size > kChunk || end > data_bytes) return false;
  }
  for (std::size_t n = 0; n < tile_count_; ++n) entries_[n].store(index[n], std::memory_order_relaxed);
  chunks_.assign(std::size_t((data_bytes + kChunk - 1) / kChunk), nullptr);
  fd_ = fd;
  data_offset_ = data_offset;
  salt_ = salt;
  return true;
}

std::optional<GridTile> TileStore::get(int level, int tile_x, int tile_y) const {
  const auto number = numberOf(level, tile_x, tile_y);
  if (!number) return std::nullopt;
  const std::uint64_t entry = entries_[*number].load(std::memory_order_acquire);
  if (kindOf(entry) == Kind::Absent) return std::nullopt;
  if (kindOf(entry) == Kind::Uniform) return uniform(std::uint8_t(offsetOf(entry)));
  if (auto cells = unpacked_->find(name_, *number)) return GridTile{std::move(cells), false, false};
  GridTile tile = unpack(*number, entry);
  if (!tile.uniform) unpacked_->insert(name_, *number, tile.cells);
  return tile;
}

GridTile TileStore::uniform(std::uint8_t value) const {
  const std::lock_guard lock(uniform_mutex_);
  auto& cells = uniform_[value];
  if (cells == nullptr) {
    auto fresh = uninitialised(kTileCells);
    std::memset(fresh.get(), value, kTileCells);
    cells = std::shared_ptr<const std::uint8_t>(fresh, fresh.get());
    ++uniform_count_;
  }
  return GridTile{cells, true, false};
}

bool TileStore::readBlob(std::uint64_t offset, std::size_t size, std::uint8_t* out) const {
  Chunk chunk;
  {
    const std::lock_guard lock(chunks_mutex_);
    chunk = chunks_[offset / kChunk];
  }
  if (chunk != nullptr) {
    std::memcpy(out, chunk.get() + offset % kChunk, size);
    return true;
  }
  // Reading instead of mapping: a truncated file gives an error instead of a signal.
  return disk::readAt(fd_, {out, size}, std::uint64_t(data_offset_) + offset);
}

GridTile TileStore::unpack(std::size_t number, std::uint64_t entry) const {
  std::array<std::uint8_t, kChecksumBytes + kTileCells> blob;
  const std::size_t size = sizeOf(entry);
  const std::uint8_t* packed = blob.data() + kChecksumBytes;
  std::uint32_t expected = 0;
  auto cells = uninitialised(kTileCells);
  bool good = readBlob(offsetOf(entry), kChecksumBytes + size, blob.data());
  if (good) {
    std::memcpy(&expected, blob.data(), kChecksumBytes);
    good = checksum(number, packed, size) == expected;
  }
  if (good && kindOf(entry) == Kind::Plain) {
    std::memcpy(cells.get(), packed, kTileCells);
  } else if (good) {
    good = LZ4_decompress_safe(reinterpret_cast<const char*>(packed), reinterpret_cast<char*>(cells.get()),
                               int(size), int(kTileCells)) == int(kTileCells);
  }
  if (!good) {
    GridTile nothing = uniform(unknown_);
    nothing.damaged = true;
    return nothing;
  }
  return GridTile{std::shared_ptr<const std::uint8_t>(cells, cells.get()), false, false};
}

std::size_t TileStore::bytes() const {
  std::size_t chunks = 0, buffers = 0;
  {
    const std::lock_guard lock(chunks_mutex_);
    chunks = resident_;
  }
  {
    const std::lock_guard lock(uniform_mutex_);
    buffers = uniform_count_;
  }
  return chunks * kChunk + tile_count_ * sizeof(std::uint64_t) + buffers * kTileCells +
         unpacked_->bytesOf(name_);
}

}  // namespace mapwright::grids
