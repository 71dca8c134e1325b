// Keeps the tiles of one raster layer (a whole map, a costmap, a difference) up to date for the current view.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "render/raster_tiles.h"
#include "render/sample_grid.h"

namespace mapwright::render {

/// The colour of every cell byte: 0xAARRGGBB, premultiplied. Outside the grid it is transparent.
using GridPalette = std::array<std::uint32_t, 256>;

/// With previews a tile is first made from a level of detail, and exactly once every tile in view has
/// something to show. Cost of a frame depends on the screen, not on the map. settled(): exactly, but with
/// previews a map that is still being read only as far as it has been.
class GridRenderer : public RasterTiles {
  Q_OBJECT
 public:
  explicit GridRenderer(Options options, QObject* parent = nullptr);

  /// Shows `placed`; with `compared` their difference (bytes are then Difference codes).
  void setGrid(std::optional<PlacedGrid> placed, std::optional<PlacedGrid> compared = {});
  const std::optional<PlacedGrid>& grid() const { return placed_; }
  /// More rows of the shown grid have been read.
  void rowsArrived();
  /// Cells of the shown or the compared grid have changed within these bounds.
  void cellsChanged(const geometry::WorldRect& where);
  void setPalette(const GridPalette& palette);
  using RasterTiles::settled;

 protected:
  bool hasContent() const override { return placed_.has_value(); }
  bool paintable() const override { return placed_ && placed_->cells; }
  void startMissing() override;
  bool settled(const ViewTile& tile) const override;
  void refresh(ViewTile& tile) override;

 private:
  void touch(const geometry::WorldRect& where);
  bool finishable() const;
  TileWorkers::Ticket start(const TileKey& key, const ViewTile& tile, Sampling sampling);

  std::optional<PlacedGrid> placed_, compared_;
  GridPalette palette_;
  int rows_seen_ = 0;
  std::uint64_t colors_ = 1;
};

}  // namespace mapwright::render
