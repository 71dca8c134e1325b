// Keeps the tiles of the current view up to date on worker threads
// (docs/decisions/0007-the-view-is-drawn-in-tiles.md).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <QImage>
#include <QObject>
#include <QPointF>
#include <QTransform>

#include "geometry/view_transform.h"
#include "map/submap.h"
#include "render/compositor.h"
#include "render/map_colors.h"
#include "work/budgets.h"

namespace mapwright::work {
class Workers;
}

namespace mapwright::render {

/// One image to draw: `image` (RGB32, opaque; ARGB32_Premultiplied if unknown is transparent, and then null
/// means that the area is empty and no stand-in may show) is mapped to viewport pixels by `to_viewport`: an
/// integer translation if the tile belongs to the present scale and rotation, otherwise (stand_in) a warped
/// picture of an earlier view.
struct DrawnTile {
  QImage image;
  QTransform to_viewport;
  bool stand_in = false;
};

/// Counters of the tile work, for the debug display, tests and benchmarks.
struct TileCounts {
  int visible = 0, exact = 0, preview = 0, pending = 0;
  std::uint64_t composed = 0, dropped_stale = 0;
  std::size_t cache_bytes = 0;  // of tiles
  std::size_t dense_bytes = 0;  // of cells prepared for drawing
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
class TileRenderer : public QObject {
  Q_OBJECT
 public:
  struct Options {
    work::Budgets budgets = work::budgetsFrom();  // it uses `tiles` and `dense`
    std::shared_ptr<work::Workers> workers = {};  // null = a thread pool of its own
    bool previews = true;                         // false: only exact tiles are shown (snapshots)
  };
  explicit TileRenderer(Options options, QObject* parent = nullptr);
  ~TileRenderer() override;

  /// Adds or replaces (same id) textures; a moved pose is a replacement with the same texture pointer.
  /// Textures without cells, or with a non-finite pose, are removed.
  void upsert(std::vector<PlacedTexture> placed);
  void remove(const std::vector<map::SubmapId>& ids);
  void clear();
  geometry::WorldRect contentBounds() const;
  std::size_t textureCount() const;

  /// A view without pixels, or with non-finite or absurd numbers (metres beyond 1e15), shows nothing.
  void setView(const geometry::ViewTransform& view);
  void setColors(const MapColors& colors, ColorMode mode);
  const MapColors& colors() const;

  /// What to paint now, back to front, covering as much of the viewport as is known. Cheap: does not compose.
  std::vector<DrawnTile> drawnTiles();

  /// True when every visible tile is exact for the present view and content.
  bool settled() const;
  TileCounts counts() const;

  /// The raw raster of the viewport from the present tiles: the whole picture if settled(). For snapshots
  /// (previews = false) it equals compose() of the view's own pixel grid, byte for byte; otherwise it is
  /// aligned with the drawn tiles, shifted by up to half a pixel.
  Composition composition() const;

  /// Intensity (0..255) at a world point from the tiles on screen, nullopt if unobserved or not known yet.
  std::optional<int> intensityAt(const Eigen::Vector2d& world_m) const;

 Q_SIGNALS:
  void tilesChanged();  // repaint; coalesced, at most once per event loop turn
  void settledChanged();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mapwright::render
