// A spatial index of textures. Private to this room; one thread.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "render/compositor.h"

namespace mapwright::render {

/// Textures by id and by position. A loose grid for every size class (powers of two of the larger side): a
/// texture is filed in the cell that contains its centre. Each grid has a tree of coarser and coarser cells,
/// kFan x kFan to one, with the contents and finest resolution of their parts: a query for a large rectangle
/// only visits a few of them, however many textures it contains.
class TextureIndex {
 public:
  static constexpr int kFanBits = 3, kFan = 1 << kFanBits;
  struct Change {
    geometry::WorldRect before, after;  // empty when absent
  };
  /// Adds or replaces. A texture without cells or with a non-finite pose counts as absent. nullopt if nothing
  /// changed.
  std::optional<Change> upsert(PlacedTexture placed);
  /// Returns its bounds; nullopt if it was not there.
  std::optional<geometry::WorldRect> remove(map::SubmapId id);
  void clear();

  std::size_t size() const { return entries_.size(); }
  geometry::WorldRect bounds() const;
  /// All textures that touch the rectangle, in painting order.
  std::vector<PlacedTexture> within(const geometry::WorldRect& rect) const;
  bool anyWithin(const geometry::WorldRect& rect) const;
  /// The smallest metres per cell of the textures that touch the rectangle; nullopt if there is none.
  std::optional<double> finestWithin(const geometry::WorldRect& rect) const;
  /// The smallest metres per cell of all; nullopt if empty.
  std::optional<double> finest() const;

 private:
  struct Entry {
    PlacedTexture placed;
    geometry::WorldRect bounds;
  };
  static constexpr int kDepth = 9;  // of the trees: from metres to larger than any map
  /// A cell of a size class; cells with a height above 0 stand for kFan x kFan of the height below.
  struct Cell {
    int size_class;
    int height;
    std::int64_t x, y;
    bool operator==(const Cell&) const = default;
  };
  struct Node {
    std::vector<const Entry*> entries;                        // at height 0
    std::uint64_t parts = 0;                                  // which parts are not empty, one bit each
    std::vector<std::pair<double, std::size_t>> resolutions;  // of all below, finest first, with their counts
  };
  struct CellHash {
    std::size_t operator()(const Cell& cell) const noexcept;
  };
  static Cell cellOf(const geometry::WorldRect& bounds);
  static Cell parentOf(const Cell& cell);
  static int partOf(const Cell& cell);  // its index in its parent
  void file(const Entry& entry);
  void unfile(const Entry& entry);
  /// Walks down the tree from `cell`. bool enter(const Node&, bool inside): whether to visit the parts;
  /// `inside` = all of it touches the rectangle. bool visit(const Entry&): false ends the walk, and the
  /// result is false.
  template <typename Enter, typename Visit>
  bool walk(const Cell& cell, const geometry::WorldRect& rect, Enter& enter, Visit& visit) const;
  template <typename Enter, typename Visit>
  void walkWithin(const geometry::WorldRect& rect, Enter enter, Visit visit) const;

  std::unordered_map<map::SubmapId, Entry> entries_;
  std::unordered_map<Cell, Node, CellHash> cells_;
  struct Class {
    std::size_t textures = 0;
    std::map<std::pair<std::int64_t, std::int64_t>, std::size_t> tops;  // the highest cells
  };
  std::map<int, Class> classes_;               // by size class
  std::map<double, std::size_t> resolutions_;  // textures by metres per cell
};

}  // namespace mapwright::render
