// Keeps the tiles of the current view up to date on worker threads
// (docs/decisions/0007-the-view-is-drawn-in-tiles.md).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "map/submap.h"
#include "render/pyramid.h"
#include "render/raster_tiles.h"
#include "render/texture_index.h"
#include "render/tile_colors.h"

namespace mapwright::render {

/// Counters of the tile work, for the debug display, tests and benchmarks.
struct TileCounts {
  int visible = 0, exact = 0, preview = 0, pending = 0;
  std::uint64_t composed = 0, dropped_stale = 0;
  std::size_t cache_bytes = 0;  // of tiles
  std::size_t dense_bytes = 0;  // of cells prepared for drawing
};

struct TileRendererOptions {
  work::Budgets budgets = work::budgetsFrom();  // it uses `tiles` and `dense`
  std::shared_ptr<work::Workers> workers = {};  // null = a thread pool of its own
  bool previews = true;                         // false: only exact tiles are shown (snapshots)
};

/// GUI-thread object; composes on the thread pool. The cost of a frame depends on the screen, not on the map.
///
/// - Textures are kept in a spatial index; changing one only dirties the tiles under its old and new bounds.
/// - Tiles are aligned with the view (its scale and rotation), so finished ones are drawn at integer offsets.
///   While they
///   are remade (zoom, new content) the best older picture is shown: old content of the same tile first (no
///   flicker,
///   no holes), otherwise warped tiles of the previous view, otherwise a quick preview.
/// - Zoomed out beyond 2 native cells per pixel, exact tiles are reduced from a world-aligned pyramid of
///   exact tiles
///   that is only remade where something changed; until then a preview from reduced textures is shown.
/// - Results for an outdated view or content are dropped (generations); tiles nearest to the centre are made
///   first.
class TileRenderer : public RasterTiles {
  Q_OBJECT
 public:
  using Options = TileRendererOptions;
  explicit TileRenderer(Options options, QObject* parent = nullptr);

  /// Adds or replaces (same id) textures; a moved pose is a replacement with the same texture pointer.
  /// Textures without cells, or with a non-finite pose, are removed.
  void upsert(std::vector<PlacedTexture> placed);
  void remove(const std::vector<map::SubmapId>& ids);
  void clear();
  geometry::WorldRect contentBounds() const { return index_.bounds(); }
  std::size_t textureCount() const { return index_.size(); }

  void setColors(const MapColors& colors, ColorMode mode);
  const MapColors& colors() const { return colors_; }

  /// What to paint now, back to front, covering as much of the viewport as is known. Cheap: does not compose.
  std::vector<DrawnTile> drawnTiles();

  using RasterTiles::settled;
  TileCounts counts() const;

  /// The raw raster of the viewport from the present tiles: the whole picture if settled(). For snapshots
  /// (previews = false) it equals compose() of the view's own pixel grid, byte for byte; otherwise it is
  /// aligned with the drawn tiles, shifted by up to half a pixel.
  Composition composition() const;

  /// Intensity (0..255) at a world point from the tiles on screen, nullopt if unobserved or not known yet.
  std::optional<int> intensityAt(const Eigen::Vector2d& world_m) const;

 protected:
  bool hasContent() const override { return true; }
  void startMissing() override;
  bool settled(const ViewTile& tile) const override { return tile.settled(); }
  void refresh(ViewTile& tile) override;
  std::uint32_t background() const override { return colors_.clear_unknown ? 0 : colors_.unknown; }
  void viewChanged() override;
  void onOther(const TileWorkers::Outcome& outcome) override;
  void keepWithin(std::size_t budget) override;

 private:
  using Compose = std::function<Composition(const std::atomic<bool>& cancelled)>;
  /// The index has changed under the rectangles.
  void contentChanged(const std::vector<geometry::WorldRect>& rects);
  bool usesPyramid() const;
  int pyramidLevel() const;
  void startPreviews();
  bool startFromPyramid(const TileKey& key, ViewTile& tile);
  void startComposing(const TileKey& key, ViewTile& tile, Quality quality);
  TileWorkers::Ticket startWork(const TileKey& key, const ViewTile& tile, bool exact, Compose compose);

  TextureIndex index_;
  std::shared_ptr<DenseCache> dense_;  // work in progress has it, too
  MapColors colors_;
  std::shared_ptr<const ColorTable> color_table_;
  std::uint64_t colors_revision_ = 1;
  Pyramid pyramid_;
  std::uint64_t pyramid_taken_ = 0, pyramid_dropped_ = 0;
};

}  // namespace mapwright::render
