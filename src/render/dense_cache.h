// Dense copies of texture levels, kept while they are in use and as long as the budget allows.
#pragma once

#include <atomic>
#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <unordered_map>

#include "raster/cell_texture.h"

namespace mapwright::render {

/// Thread-safe least-recently-used cache with a budget in bytes. Entries in use stay alive through their shared_ptr.
class DenseCache {
 public:
  explicit DenseCache(std::size_t budget_bytes = std::size_t(64) << 20);
  std::shared_ptr<const raster::DenseCells> get(const std::shared_ptr<const raster::CellTexture>& texture, int level);
  std::size_t bytes() const;
  void clear();

 private:
  struct Entry;
  struct Key {
    const raster::CellTexture* texture;
    int level;
    bool operator==(const Key&) const = default;
  };
  struct KeyHash {
    std::size_t operator()(const Key& key) const noexcept;
  };
  std::size_t budget_;
  mutable std::mutex mutex_;
  std::list<Entry> entries_;  // most recently used first
  std::unordered_map<Key, std::list<Entry>::iterator, KeyHash> index_;
  std::size_t bytes_ = 0;
};

}  // namespace mapwright::render
