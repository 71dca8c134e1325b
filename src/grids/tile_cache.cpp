#include "grids/tile_cache.h"

#include <algorithm>

namespace mapwright::grids {

TileCache::TileCache(std::size_t budget_bytes)
    : shard_capacity_(std::max<std::size_t>(1, budget_bytes / kTileBytes / kShards)) {}

TileCache::Cells TileCache::find(std::uint64_t owner, std::uint64_t tile) {
  const Key key{owner, tile};
  Shard& shard = shardOf(key);
  const std::lock_guard lock(shard.mutex);
  const auto found = shard.by_key.find(key);
  if (found == shard.by_key.end()) return nullptr;
  shard.order.splice(shard.order.begin(), shard.order, found->second);
  return found->second->second;
}

void TileCache::insert(std::uint64_t owner, std::uint64_t tile, Cells cells) {
  const Key key{owner, tile};
  Shard& shard = shardOf(key);
  const std::lock_guard lock(shard.mutex);
  if (shard.by_key.contains(key)) return;  // another thread was faster
  shard.order.emplace_front(key, std::move(cells));
  shard.by_key.emplace(key, shard.order.begin());
  if (shard.order.size() > shard_capacity_) {
    shard.by_key.erase(shard.order.back().first);
    shard.order.pop_back();
  }
}

void TileCache::forget(std::uint64_t owner) {
  for (Shard& shard : shards_) {
    const std::lock_guard lock(shard.mutex);
    std::erase_if(shard.by_key, [&](const auto& entry) { return entry.first.owner == owner; });
    std::erase_if(shard.order, [&](const auto& entry) { return entry.first.owner == owner; });
  }
}

std::size_t TileCache::bytes() const {
  std::size_t tiles = 0;
  for (const Shard& shard : shards_) {
    const std::lock_guard lock(shard.mutex);
    tiles += shard.order.size();
  }
  return tiles * kTileBytes;
}

std::size_t TileCache::bytesOf(std::uint64_t owner) const {
  std::size_t tiles = 0;
  for (const Shard& shard : shards_) {
    const std::lock_guard lock(shard.mutex);
    tiles += std::size_t(std::count_if(shard.order.begin(), shard.order.end(),
                                       [&](const auto& entry) { return entry.first.owner == owner; }));
  }
  return tiles * kTileBytes;
}

}  // namespace mapwright::grids
