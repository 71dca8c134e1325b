// The tiles that were unpacked last. Any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <utility>

namespace mapwright::raster {

/// Least recently used go first. Split by key into shards with a lock each, so that threads that draw
/// neighbouring tiles seldom meet.
class TileCache {
 public:
  using Cells = std::shared_ptr<const std::uint8_t>;
  explicit TileCache(std::size_t capacity_tiles);
  Cells find(std::uint64_t key);  // null: not there
  void insert(std::uint64_t key, Cells cells);
  std::size_t tiles() const;

 private:
  static constexpr std::size_t kShards = 8;
  struct Shard {
    mutable std::mutex mutex;
    std::list<std::pair<std::uint64_t, Cells>> order;  // most recent first
    std::unordered_map<std::uint64_t, std::list<std::pair<std::uint64_t, Cells>>::iterator> places;
  };
  Shard& shardOf(std::uint64_t key) { return shards_[key % kShards]; }

  std::size_t shard_capacity_;
  std::array<Shard, kShards> shards_;
};

}  // namespace mapwright::raster
