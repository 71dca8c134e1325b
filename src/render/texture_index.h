// A spatial index of textures. Private to this room; one thread.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "render/compositor.h"

namespace mapwright::render {

/// Textures by id and by position.
class TextureIndex {
 public:
  TextureIndex();
  ~TextureIndex();

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
  struct Tree;
  void file(const Entry& entry);
  void unfile(const Entry& entry);

  std::unordered_map<map::SubmapId, Entry> entries_;
  std::unique_ptr<Tree> tree_;                 // of entries
  std::map<double, std::size_t> resolutions_;  // textures by metres per cell
};

}  // namespace mapwright::render
