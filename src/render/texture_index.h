// Which textures lie where. Private to this room; one thread.
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

/// Textures by id and by place. A loose grid for every size class (powers of two of the larger side): a
/// texture is filed in the one cell that holds its centre. Over each grid stands a tree of coarser and
/// coarser cells, kFan x kFan to one, that know which of their parts hold something and how fine it is: a
/// question about a large rectangle is answered from few of them, however many textures lie in it.
class TextureIndex {
 public:
  static constexpr int kFanBits = 3, kFan = 1 << kFanBits;
  struct Change {
    geometry::WorldRect before, after;  // empty when absent
  };
  /// Adds or replaces. A texture without cells or with a pose that is not finite counts as absent. nullopt
  /// when nothing changed.
  std::optional<Change> upsert(PlacedTexture placed);
  /// The bounds it had; nullopt when it was not there.
  std::optional<geometry::WorldRect> remove(map::SubmapId id);
  void clear();

  std::size_t size() const { return entries_.size(); }
  geometry::WorldRect bounds() const;
  /// What touches the rectangle, in painting order.
  std::vector<PlacedTexture> within(const geometry::WorldRect& rect) const;
  bool anyWithin(const geometry::WorldRect& rect) const;
  /// The smallest metres per cell among what touches the rectangle; nullopt when nothing does.
  std::optional<double> finestWithin(const geometry::WorldRect& rect) const;
  /// The smallest metres per cell of all; nullopt when empty.
  std::optional<double> finest() const;

 private:
  struct Entry {
    PlacedTexture placed;
    geometry::WorldRect bounds;
  };
  static constexpr int kDepth = 9;  // of the trees: from metres to beyond any map
  /// A cell of a size class; cells of a height above 0 stand for kFan x kFan of the height below.
  struct Cell {
    int size_class;
    int height;
    std::int64_t x, y;
    bool operator==(const Cell&) const = default;
  };
  struct Node {
    std::vector<const Entry*> entries;                        // at height 0
    std::uint64_t parts = 0;                                  // that hold something, above it; a bit each
    std::vector<std::pair<double, std::size_t>> resolutions;  // of all below, finest first, with their counts
  };
  struct CellHash {
    std::size_t operator()(const Cell& cell) const noexcept;
  };
  static Cell cellOf(const geometry::WorldRect& bounds);
  static Cell parentOf(const Cell& cell);
  static int partOf(const Cell& cell);  // its place in its parent
  void file(const Entry& entry);
  void unfile(const Entry& entry);
  /// Walks down the tree from `cell`. bool enter(const Node&, bool inside): whether to look at what is below;
  /// `inside` = all of it touches the rectangle. bool visit(const Entry&): false ends the walk, and so the
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
