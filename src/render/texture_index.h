// Which textures lie where. Private to this room; one thread.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

#include "render/compositor.h"

namespace mapwright::render {

/// Textures by id and by place. A loose grid for every size class (powers of two of the larger side): a
/// texture is filed in the one cell that holds its centre, so that moving it costs two hash operations
/// however large the map is.
class TextureIndex {
 public:
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
  struct Cell {
    int size_class;
    std::int64_t x, y;
    bool operator==(const Cell&) const = default;
  };
  struct CellHash {
    std::size_t operator()(const Cell& cell) const noexcept;
  };
  static Cell cellOf(const geometry::WorldRect& bounds);
  void file(const Entry& entry);
  void unfile(const Entry& entry);
  template <typename Visit>  // bool visit(const Entry&): false stops
  void visitWithin(const geometry::WorldRect& rect, Visit visit) const;

  std::unordered_map<map::SubmapId, Entry> entries_;
  std::unordered_map<Cell, std::vector<const Entry*>, CellHash> cells_;
  std::map<int, std::size_t> class_counts_;    // textures by size class
  std::map<double, std::size_t> resolutions_;  // textures by metres per cell
};

}  // namespace mapwright::render
