// Keeps the tiles of one raster layer (a whole map, a costmap, a difference) up to date for the current view.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <QObject>
#include <QRegion>

#include "geometry/view_transform.h"
#include "render/sample_grid.h"
#include "render/tile_renderer.h"

namespace mapwright::render {

/// The colour of every cell byte: 0xAARRGGBB, premultiplied. Outside the grid it is transparent.
using GridPalette = std::array<std::uint32_t, 256>;

/// How many bytes several renderers may use together. GUI thread.
struct TileBudget {
  std::size_t bytes = work::budgetsFrom().grid_tiles;
  std::size_t held = 0;  // used by those that share it
};

/// GUI-thread object; samples on the thread pool, like TileRenderer: tiles are aligned with the view's pixels
/// and drawn at integer offsets; old content or an old view is shown until the new one is ready. With
/// previews a tile is first made from a coarser level, and exactly once every visible tile has something to
/// show. The cost of a frame depends on the screen, not on the map.
class GridRenderer : public QObject {
  Q_OBJECT
 public:
  struct Options {
    std::shared_ptr<TileBudget> budget = {};      // null = a private one
    std::shared_ptr<work::Workers> workers = {};  // null = a thread pool of its own
    bool previews = true;                         // false: only exact tiles are shown (snapshots)
  };
  explicit GridRenderer(Options options, QObject* parent = nullptr);
  ~GridRenderer() override;

  /// Shows `placed`; with `compared` their difference (bytes are then Difference codes).
  void setGrid(std::optional<PlacedGrid> placed, std::optional<PlacedGrid> compared = {});
  const std::optional<PlacedGrid>& grid() const;
  /// More rows of the shown grid have been read.
  void rowsArrived();
  /// Cells of the shown or the compared grid have changed within these bounds.
  void cellsChanged(const geometry::WorldRect& where);
  void setPalette(const GridPalette& palette);
  /// A view without pixels shows nothing. Device pixels.
  void setView(const geometry::ViewTransform& view);
  /// While inactive nothing is rendered; activation renders what is missing.
  void setActive(bool active);

  /// What to paint now: stand-ins (outside `exact_region`) first, then finished tiles.
  struct Drawing {
    std::vector<DrawnTile> stand_ins, tiles;
    QRegion covered;  // viewport pixels that need no stand-in
  };
  Drawing drawing();

  /// Every visible tile shows everything read of the present content: exactly, or as a preview while a map is
  /// still being read.
  bool settled() const;
  std::size_t cacheBytes() const;

 Q_SIGNALS:
  void tilesChanged();  // repaint; coalesced
  void settledChanged();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mapwright::render
