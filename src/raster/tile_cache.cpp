#include "raster/tile_cache.h"

#include <algorithm>

namespace mapwright::raster {

TileCache::TileCache(std::size_t capacity_tiles)
    : shard_capacity_(std::max<std::size_t>(1, capacity_tiles / kShards)) {}

TileCache::Cells TileCache::find(std::uint64_t key) {
  Shard& shard = shardOf(key);
  const std::lock_guard lock(shard.mutex);
  const auto place = shard.places.find(key);
  if (place == shard.places.end()) return nullptr;
  shard.order.splice(shard.order.begin(), shard.order, place->second);
  return place->second->second;
}

void TileCache::insert(std::uint64_t key, Cells cells) {
  Shard& shard = shardOf(key);
  const std::lock_guard lock(shard.mutex);
  if (shard.places.contains(key)) return;  // another thread was faster
  shard.order.emplace_front(key, std::move(cells));
  shard.places.emplace(key, shard.order.begin());
  if (shard.order.size() > shard_capacity_) {
    shard.places.erase(shard.order.back().first);
    shard.order.pop_back();
  }
}

std::size_t TileCache::tiles() const {
  std::size_t count = 0;
  for (const Shard& shard : shards_) {
    const std::lock_guard lock(shard.mutex);
    count += shard.order.size();
  }
  return count;
}

}  // namespace mapwright::raster
