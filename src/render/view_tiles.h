// The tiles aligned with the present view. Private to this room; GUI thread.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "geometry/view_transform.h"
#include "render/stand_ins.h"
#include "render/tile_workers.h"

namespace mapwright::render {

/// Tile (x, y) covers kTileEdge x kTileEdge pixels of the view's infinite raster.
struct TileKey {
  std::int64_t x = 0, y = 0;
  auto operator<=>(const TileKey&) const = default;
};

struct ViewTile {
  Picture picture;                                       // pixels null: nothing yet, or the tile is empty
  bool known = false;                                    // has something to show, even if that is empty
  bool exact = false;                                    // what it shows is not a preview
  std::uint64_t shown = 0;                               // generation of the displayed content
  std::uint64_t touched = 0;                             // latest generation that changed something under it
  std::uint64_t colors = 0;                              // revision of the colours of picture.image
  TileWorkers::Ticket exact_work = 0, preview_work = 0;  // in progress, 0 = none
  std::uint64_t last_visible = 0;
  bool current() const { return known && shown >= touched; }
  bool settled() const { return current() && exact; }
  /// Filling holes comes before updating or refining.
  work::Urgency urgency() const { return known ? work::Urgency::Wanted : work::Urgency::InView; }
};

/// Tiles by position. Their raster is anchored at the world origin so that panning keeps them; that of a
/// snapshot at the corner of its first pixel so that pixels are exactly where requested.
class ViewTiles {
 public:
  explicit ViewTiles(bool snapshot) : snapshot_(snapshot) {}

  /// True if the raster changed: all tiles are then dropped (save what is needed with pictures() first).
  bool rasterChanges(const geometry::ViewTransform& view) const;
  void setView(const geometry::ViewTransform& view);
  const geometry::ViewTransform& view() const { return view_; }

  /// Visible, nearest to the centre first.
  const std::vector<TileKey>& visible() const { return visible_; }
  ViewTile& at(const TileKey& key);  // created when new
  ViewTile* find(const TileKey& key);
  const ViewTile* find(const TileKey& key) const;
  PixelGrid gridOf(const TileKey& key) const;
  /// Viewport pixel of the tile's first pixel: integers.
  QPointF offsetOf(const TileKey& key) const;
  /// The tile and its pixel for a world point; nullopt if there is none.
  struct Pixel {
    TileKey key;
    int column = 0, row = 0;
  };
  std::optional<Pixel> pixelAt(const Eigen::Vector2d& world_m) const;

  /// Marks everything under the rectangles as changed in `generation` and passes each tile to `outdated`.
  template <typename Outdated>
  void touch(const std::vector<geometry::WorldRect>& rects, std::uint64_t generation, Outdated outdated);
  void setPicture(ViewTile& tile, std::shared_ptr<const Composition> pixels, QImage image,
                  std::uint64_t colors);
  /// Pictures of the tiles that have one: the visible ones and at most `others` more.
  std::vector<Picture> pictures(std::size_t others) const;
  template <typename Visit>
  void forEach(Visit visit) {
    for (auto& [key, tile] : tiles_) visit(tile);
  }

  void clear();
  std::size_t bytes() const { return bytes_; }
  /// Drops invisible tiles, longest invisible first, until bytes() <= budget.
  void trim(std::size_t budget_bytes);

 private:
  // Tiles touched by a world rectangle, as a range of (clamped) keys.
  struct KeyRange {
    double x0, y0, x1, y1;
  };
  KeyRange keysUnder(const geometry::WorldRect& rect) const;
  void listVisible();

  bool snapshot_;
  geometry::ViewTransform view_{.width_px = 0, .height_px = 0};
  PixelGrid raster_;
  double offset_x_ = 0, offset_y_ = 0;  // viewport pixel of raster pixel (0, 0), integers
  std::map<TileKey, ViewTile> tiles_;
  std::vector<TileKey> visible_;
  std::uint64_t views_ = 0;
  std::size_t bytes_ = 0;
};

template <typename Outdated>
void ViewTiles::touch(const std::vector<geometry::WorldRect>& rects, std::uint64_t generation,
                      Outdated outdated) {
  const auto mark = [&](ViewTile& tile) {
    if (tile.touched == generation) return;
    tile.touched = generation;
    outdated(tile);
  };
  for (const geometry::WorldRect& rect : rects) {
    if (rect.empty() || tiles_.empty()) continue;
    const KeyRange range = keysUnder(rect);
    if ((range.x1 - range.x0 + 1) * (range.y1 - range.y0 + 1) > double(tiles_.size())) {
      for (auto& [key, tile] : tiles_) {
        const auto x = double(key.x), y = double(key.y);
        if (x >= range.x0 && x <= range.x1 && y >= range.y0 && y <= range.y1) mark(tile);
      }
      continue;
    }
    for (auto y = std::int64_t(range.y0); y <= std::int64_t(range.y1); ++y) {
      for (auto x = std::int64_t(range.x0); x <= std::int64_t(range.x1); ++x) {
        if (ViewTile* const tile = find({x, y})) mark(*tile);
      }
    }
  }
}

}  // namespace mapwright::render
