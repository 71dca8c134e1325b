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

/// The colour of every cell byte: 0xAARRGGBB, premultiplied. What is outside the grid is transparent.
using GridPalette = std::array<std::uint32_t, 256>;

/// What several renderers may keep together, bytes. GUI thread.
struct TileBudget {
  std::size_t bytes = work::budgetsFrom().grid_tiles;
  std::size_t held = 0;  // by those that have it
};

/// GUI-thread object; samples on the crew, like TileRenderer: tiles lie in the grid of the view and are drawn
/// at integer offsets; a replaced content or view stands in until the new one is there. With previews a tile
/// is first made from a level of detail, and exactly once every tile in view has something to show. Cost of a
/// frame depends on the screen, not on the map.
class GridRenderer : public QObject {
  Q_OBJECT
 public:
  struct Options {
    std::shared_ptr<TileBudget> budget = {};      // null = one of its own
    std::shared_ptr<work::Workers> workers = {};  // null = a crew of its own
    bool previews = true;                         // false: only exact tiles are ever shown (snapshots)
  };
  explicit GridRenderer(Options options, QObject* parent = nullptr);
  ~GridRenderer() override;

  /// Shows `placed`; with `compared` the difference between the two (bytes are then Difference codes).
  void setGrid(std::optional<PlacedGrid> placed, std::optional<PlacedGrid> compared = {});
  const std::optional<PlacedGrid>& grid() const;
  /// More rows of the shown grid have been read.
  void rowsArrived();
  /// Cells of the shown grid, or of the compared one, have become others within these bounds.
  void cellsChanged(const geometry::WorldRect& where);
  void setPalette(const GridPalette& palette);
  /// A view without pixels shows nothing. Device pixels.
  void setView(const geometry::ViewTransform& view);
  /// While switched off nothing is made; switching on makes what is missing.
  void setActive(bool active);

  /// What to paint now: stand-ins (outside `exact_region`) first, then finished tiles.
  struct Drawing {
    std::vector<DrawnTile> stand_ins, tiles;
    QRegion covered;  // viewport pixels that need no stand-in
  };
  Drawing drawing();

  /// Every visible tile shows all that has been read of the present content: exactly, but with previews a map
  /// that is still being read.
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
