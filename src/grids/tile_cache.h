// The recently unpacked tiles of any number of pyramids. Any thread.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <utility>

namespace mapwright::grids {

/// Evicts the least recently used. Split by key into shards with a lock each, so that threads drawing
/// neighbouring tiles rarely block each other.
class TileCache {
 public:
  using Cells = std::shared_ptr<const std::uint8_t>;
  static constexpr std::size_t kTileBytes = 65'536;
  static constexpr std::size_t kUsualBytes = std::size_t(64) << 20;

  explicit TileCache(std::size_t budget_bytes = kUsualBytes);

  /// An id for the owner of tiles.
  std::uint64_t newOwner() { return ++last_owner_; }
  Cells find(std::uint64_t owner, std::uint64_t tile);  // null: not cached
  /// `cells`: kTileBytes.
  void insert(std::uint64_t owner, std::uint64_t tile, Cells cells);
  /// Removes all tiles of the owner.
  void forget(std::uint64_t owner);

  std::size_t bytes() const;
  std::size_t bytesOf(std::uint64_t owner) const;
  std::size_t budget() const { return shard_capacity_ * kShards * kTileBytes; }

 private:
  static constexpr std::size_t kShards = 8;
  struct Key {
    std::uint64_t owner, tile;
    bool operator==(const Key&) const = default;
  };
  struct KeyHash {
    std::size_t operator()(const Key& key) const noexcept {
      return std::size_t(key.tile * 0x9e3779b97f4a7c15u ^ key.owner);
    }
  };
  struct Shard {
    mutable std::mutex mutex;
    std::list<std::pair<Key, Cells>> order;  // most recent first
    std::unordered_map<Key, std::list<std::pair<Key, Cells>>::iterator, KeyHash> by_key;
  };
  Shard& shardOf(const Key& key) { return shards_[(key.tile + key.owner) % kShards]; }

  std::size_t shard_capacity_;
  std::atomic<std::uint64_t> last_owner_{0};
  std::array<Shard, kShards> shards_;
};

}  // namespace mapwright::grids
