// Dense copies of texture levels, kept while in use and as long as the budget allows.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

namespace mapwright::cells {
class CellTexture;
}

namespace mapwright::render {

struct TapCells;

/// Thread-safe least-recently-used cache with a budget in bytes. Entries in use stay alive through their
/// shared_ptr.
class DenseCache {
 public:
  explicit DenseCache(std::size_t budget_bytes = std::size_t(64) << 20);
  ~DenseCache();
  DenseCache(const DenseCache&) = delete;
  DenseCache& operator=(const DenseCache&) = delete;

  /// The level prepared for sampling, from the cache or expanded now. Preconditions: texture set, level
  /// within its levels.
  std::shared_ptr<const TapCells> get(const std::shared_ptr<const cells::CellTexture>& texture, int level);
  std::size_t bytes() const;
  void clear();

 private:
  struct Entry;
  struct Key {
    const cells::CellTexture* texture;
    int level;
    bool operator==(const Key&) const = default;
  };
  struct KeyHash {
    std::size_t operator()(const Key& key) const noexcept;
  };
  /// Memory for an expansion: allocating a block as large as a texture costs more than filling it. There are
  /// as many as parallel expansions.
  std::vector<std::uint8_t> reuseSpare();

  std::size_t budget_;
  mutable std::mutex mutex_;
  std::vector<std::vector<std::uint8_t>> spares_;
  std::list<Entry> entries_;  // most recently used first
  std::unordered_map<Key, std::list<Entry>::iterator, KeyHash> index_;
  std::size_t bytes_ = 0;
};

}  // namespace mapwright::render
