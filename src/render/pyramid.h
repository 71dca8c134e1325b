// The world-aligned pyramid of exact tiles: which are known, in progress or outdated. Private to this room;
// lives in the GUI thread. Why: docs/decisions/0007-the-view-is-drawn-in-tiles.md.
#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <optional>
#include <unordered_map>
#include <vector>

#include "render/pyramid_tile.h"
#include "render/texture_index.h"
#include "render/tile_workers.h"

namespace mapwright::render {

/// Tiles are made on demand, from the bottom up: composed directly if a pixel is at most kDirectCells cells
/// of the finest texture there, otherwise halved from the four tiles below. A change only outdates the tiles
/// it touches.
class Pyramid {
 public:
  static constexpr double kDirectCells = 4;

  Pyramid(const TextureIndex& index, TileWorkers& workers, std::shared_ptr<DenseCache> dense);

  /// The pixel width of level 0. Set once, from the first texture; a change drops everything.
  void setBase(double base_m_per_px);
  double base() const { return base_m_per_px_; }

  /// Fills `patch` with current tiles. True if all are there; otherwise starts as many of the missing ones as
  /// possible, and the caller asks again when work has finished.
  bool request(PyramidPatch& patch);
  /// How many tiles of the patch are not current.
  int missing(const PyramidPatch& patch) const;

  /// Outdates everything under the rectangles and cancels work on it.
  void invalidate(const std::vector<geometry::WorldRect>& rects);
  void clear();

  /// Takes the result of work started by request(). nullopt: not from there; otherwise whether it is still
  /// useful.
  std::optional<bool> onOutcome(const TileWorkers::Outcome& outcome);

  std::size_t bytes() const { return bytes_; }
  /// Starts a round: tiles requested from now on are safe from trim().
  void beginRound() { ++round_; }
  /// Drops tiles that were not requested in this round, least recently used first, until bytes() <= budget.
  void trim(std::size_t budget_bytes);

 private:
  struct KeyHash {
    std::size_t operator()(const PyramidKey& key) const noexcept;
  };
  struct Node {
    PyramidTilePtr tile;
    bool current = false;
    TileWorkers::Ticket ticket = 0;  // of the work in progress, 0 = none
    std::optional<bool> direct;      // composed, not halved; unknown until asked
    std::uint64_t round = 0;         // last asked for
    std::list<PyramidKey>::iterator used;
  };
  enum class State { Current, Pending };
  State ask(const PyramidKey& key);
  void outdate(Node& node);
  Node& nodeFor(const PyramidKey& key);
  State setCurrent(Node& node, PyramidTilePtr tile);
  State compose(const PyramidKey& key, Node& node);
  State halve(const PyramidKey& key);

  const TextureIndex& index_;
  TileWorkers& workers_;
  std::shared_ptr<DenseCache> dense_;
  double base_m_per_px_ = 0;
  std::unordered_map<PyramidKey, Node, KeyHash> nodes_;
  std::unordered_map<TileWorkers::Ticket, PyramidKey> in_progress_;
  std::unordered_map<int, std::size_t> nodes_by_level_;
  std::list<PyramidKey> recent_;  // most recently used first
  std::uint64_t round_ = 1;
  std::size_t bytes_ = 0;
};

}  // namespace mapwright::render
