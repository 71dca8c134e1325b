// How much memory the program's caches may use together, and its distribution.
#pragma once

#include <cstddef>

namespace mapwright::work {

/// The memory of all caches in bytes: their limits, or their present use. Visible data is never dropped; the
/// limits concern data kept for later.
struct Budgets {
  std::size_t textures = 0;    // submaps' cells, packed
  std::size_t dense = 0;       // submaps' cells, prepared for drawing
  std::size_t tiles = 0;       // of submaps: of the view, and of coarser levels
  std::size_t grid_tiles = 0;  // of the views of all whole maps, costmaps and differences
  std::size_t unpacked = 0;    // recently used cells of whole maps
  std::size_t regions = 0;     // cells of maps by regions

  std::size_t all() const { return textures + dense + tiles + grid_tiles + unpacked + regions; }
  bool operator==(const Budgets&) const = default;
  friend Budgets operator+(const Budgets& a, const Budgets& b) {
    return {a.textures + b.textures,     a.dense + b.dense,       a.tiles + b.tiles,
            a.grid_tiles + b.grid_tiles, a.unpacked + b.unpacked, a.regions + b.regions};
  }
};

inline constexpr std::size_t kLeastBudget = std::size_t(128) << 20;
inline constexpr std::size_t kUsualBudget = std::size_t(768) << 20;

/// Distributes `bytes` (at least kLeastBudget).
Budgets budgetsFrom(std::size_t bytes = kUsualBudget);

}  // namespace mapwright::work
