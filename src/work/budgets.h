// How much memory the program's caches may take together, and who gets which part of it.
#pragma once

#include <cstddef>

namespace mapwright::work {

/// One account for all caches in memory, bytes: what they may hold, or what they do. What is on screen is
/// never given up, whatever it takes; these bound what is kept for later.
struct Budgets {
  std::size_t textures = 0;    // submaps' cells, packed
  std::size_t dense = 0;       // submaps' cells, laid out for the compositor
  std::size_t tiles = 0;       // of submaps: the view's, and of coarser levels
  std::size_t grid_tiles = 0;  // of all whole maps, costmaps and differences: the views'
  std::size_t unpacked = 0;    // cells of whole maps that were looked at last
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

/// Shares `bytes` out (at least kLeastBudget).
Budgets budgetsFrom(std::size_t bytes = kUsualBudget);

}  // namespace mapwright::work
