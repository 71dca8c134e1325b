// Decides which tile to work on next and stores the results. Private to this room; GUI thread. Why:
// docs/decisions/0007-the-view-is-drawn-in-tiles.md.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <unordered_map>
#include <vector>

#include "render/pyramid.h"
#include "render/texture_index.h"
#include "render/tile_colors.h"
#include "render/tile_renderer.h"
#include "render/tile_workers.h"
#include "render/view_tiles.h"

namespace mapwright::render {

/// The tiles of a view over an index of textures, kept up to date by workers. Passive: proceed() starts as
/// much work as possible, and `changed` is called when the picture or the progress has changed.
class TileWork {
 public:
  TileWork(const TileRenderer::Options& options, std::function<void()> changed);

  TextureIndex& index() { return index_; }
  const TextureIndex& index() const { return index_; }
  const ViewTiles& tiles() const { return tiles_; }
  const StandIns& standIns() const { return stand_ins_; }

  void setView(const geometry::ViewTransform& view);
  void setColors(const MapColors& colors, ColorMode mode);
  const MapColors& colors() const { return colors_; }
  /// The index has changed under the rectangles.
  void contentChanged(const std::vector<geometry::WorldRect>& rects);
  void contentCleared();

  /// Starts the most urgent work.
  void proceed();
  /// The image of a tile in the present colours; null if it is empty.
  QImage imageOf(const TilePlace& place);
  bool settled() const;
  TileCounts counts() const;

 private:
  struct ViewWork {
    TilePlace place;
    std::uint64_t raster = 0, generation = 0, colors = 0;
    bool exact = false;
  };
  bool usesPyramid() const;
  void receive(std::vector<TileWorkers::Outcome> outcomes);
  void take(const ViewWork& work, TileWorkers::Outcome& outcome);
  void markEmptyGround();
  void startPreviews();
  void startExact();
  bool startFromPyramid(const TilePlace& place, ViewTile& tile);
  void startComposing(const TilePlace& place, ViewTile& tile, Quality quality);
  using Compose = std::function<Composition(const std::atomic<bool>& cancelled)>;
  TileWorkers::Ticket startWork(const TilePlace& place, const ViewTile& tile, bool exact, Compose compose);
  int pyramidLevel() const;
  void cancelWork(ViewTile& tile);
  void dropStandInsWhenCovered();
  void trim();

  TileRenderer::Options options_;
  std::function<void()> changed_;
  TextureIndex index_;
  DenseCache dense_;
  ViewTiles tiles_;
  StandIns stand_ins_;
  MapColors colors_;
  std::shared_ptr<const ColorTable> color_table_;
  std::uint64_t colors_revision_ = 1;
  std::uint64_t raster_ = 0;      // counts changes of the view's raster
  std::uint64_t generation_ = 0;  // counts changes of the content
  std::unordered_map<TileWorkers::Ticket, ViewWork> under_way_;
  std::uint64_t composed_ = 0, dropped_stale_ = 0;
  TileWorkers workers_;  // last of what running work refers to: its destructor waits for that work
  Pyramid pyramid_;
};

}  // namespace mapwright::render
