// The raster layers of a session: whole map, overview, compared map, difference, costmaps and so on. Private
// to this room.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>

#include <QObject>

#include "render/grid_renderer.h"
#include "session/session.h"
#include "ui/scene/layer_item.h"

namespace mapwright::session {
struct LayerGrid;
}

namespace mapwright::ui::scene {

/// A picture of cells: a whole map, a costmap, a difference.
class RasterLayer : public DeviceLayer {
 public:
  explicit RasterLayer(const LayerContext& context);
  render::GridRenderer& renderer() { return renderer_; }
  const std::optional<render::PlacedGrid>& grid() const { return renderer_.grid(); }
  /// Of the grid; empty without one.
  geometry::WorldRect gridBounds() const;
  geometry::WorldRect contentBounds() const override { return gridBounds(); }
  /// Half as opaque as its layer is.
  void setFaint(bool faint) { faint_ = faint; }
  bool faint() const { return faint_; }
  void setActive(bool active) override { renderer_.setActive(active); }
  bool settled() const override { return renderer_.settled(); }
  std::size_t cacheBytes() const override { return renderer_.cacheBytes(); }

 protected:
  void onViewChanged(const geometry::ViewTransform& device_view) override { renderer_.setView(device_view); }
  void paintPixels(QPainter& painter, const QRectF& exposed) override;

 private:
  render::GridRenderer renderer_;
  bool faint_ = false;
};

/// The colours of a grid that a robot sends (robot_grid_layers.cpp).
render::GridPalette gridPalette(map::GridKind kind, const session::LayerGrid& grid, const MapTheme& theme);

/// GUI thread. Makes the items; the scene that they are added to owns them.
class RasterStack : public QObject {
  Q_OBJECT
 public:
  explicit RasterStack(const LayerContext& context);

  /// The rasters of a layer; those of a map by regions: one for each possible cell lattice.
  std::vector<RasterLayer*> itemsOf(Layer layer) const;
  RasterLayer* reference() const { return reference_; }
  RasterLayer* whole() const { return whole_; }
  RasterLayer* overview() const { return overview_; }
  RasterLayer* compared() const { return compared_; }
  RasterLayer* difference() const { return difference_; }

  /// Not owned; null = none.
  void setSession(session::Session* session);
  void themeChanged();

  /// Every visible map is completely read.
  bool read() const;
  /// A map from elsewhere, as it was laid; it does not belong to the session. nullopt = none.
  void setReference(std::optional<render::PlacedGrid> placed);
  /// Half transparent, above the others.
  void setReferenceAbove(bool above);
  bool referenceAbove() const { return reference_above_; }
  /// What differs between it and the whole map, above both.
  void setReferenceDifferences(bool shown);
  bool referenceDifferences() const { return reference_differences_; }
  /// Shown instead of the cells of the whole map while that is the map `map`; null = none.
  void setEdited(const map::MapKey& map, std::shared_ptr<const grids::GridPyramid> cells);
  void editedChanged(const geometry::WorldRect& where);

  void regionSheetsChanged();
  void regionCellsChanged(const geometry::WorldRect& where);
  geometry::WorldRect regionBounds() const;
  /// The cell of a region at a point; nullopt if it is unknown or not fetched.
  std::optional<int> regionOccupancyAt(const Eigen::Vector2d& world_m) const;

 Q_SIGNALS:
  void contentChanged();  // another map, or its end

 private:
  std::optional<render::PlacedGrid> placedOf(const session::MapSlot& slot) const;
  void syncSlot(const session::MapSlot& slot, RasterLayer& raster);
  void syncDifference();
  void syncReference();
  void syncGrid(map::GridKind kind);

  const LayerContext& context_;
  session::Session* session_ = nullptr;
  RasterLayer *const reference_, *const whole_, *const overview_, *const compared_, *const difference_;
  std::map<map::GridKind, RasterLayer*> grids_;
  std::array<RasterLayer*, regions::RegionCells::kMostSheets> region_sheets_;
  std::optional<render::PlacedGrid> laid_;  // the reference map
  bool reference_above_ = false, reference_differences_ = false;
  map::MapKey edited_map_;
  std::shared_ptr<const grids::GridPyramid> edited_;
};

}  // namespace mapwright::ui::scene
