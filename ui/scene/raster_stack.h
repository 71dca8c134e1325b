// The raster layers of a session: whole map, overview, compared map, difference, costmaps and so on, each
// with its renderer.
#pragma once

#include <array>
#include <map>
#include <memory>

#include <QObject>

#include "regions/region_map.h"
#include "render/grid_renderer.h"
#include "scene/layer.h"
#include "scene/live_layers.h"
#include "session/session.h"

namespace mapwright::scene {

/// GUI thread. Makes the items; the scene that they are added to owns them.
class RasterStack : public QObject {
  Q_OBJECT
 public:
  RasterStack(const LayerContext& context, render::RasterTiles::Options options, QObject* parent);
  ~RasterStack() override;

  /// What the renderers were made with: the budget is one for all.
  const render::RasterTiles::Options& options() const { return options_; }

  /// The item of a raster layer; nullptr for any other.
  RasterLayer* item(Layer layer) const;
  RasterLayer* overview() const { return overview_.item; }
  RasterLayer* compared() const { return compared_.item; }
  RasterLayer* difference() const { return difference_.item; }
  /// All items, bottom first.
  std::vector<RasterLayer*> items() const;
  /// Those of a map by regions: one for each possible cell lattice.
  std::vector<RasterLayer*> regionItems() const;

  /// Not owned; null = none.
  void setSession(session::Session* session);
  void setTheme(const MapTheme& theme);
  /// The camera has changed.
  void sendView();
  /// Applies which items are visible: the others render nothing.
  void syncActive();

  /// Everything visible is drawn as far as it has been read.
  bool drawn() const;
  /// And completely read.
  bool settled() const;
  geometry::WorldRect wholeBounds() const;
  geometry::WorldRect comparedBounds() const;
  bool overviewShown() const;
  std::size_t cacheBytes() const;
  std::optional<render::PlacedGrid> wholeMap() const;
  std::optional<render::PlacedGrid> comparedMap() const;
  /// Shown instead of the cells of the whole map while that is the map `map`; null = none.
  void setEdited(const map::MapKey& map, std::shared_ptr<const grids::GridPyramid> cells);
  void editedChanged(const geometry::WorldRect& where);

  /// Not owned; null = none.
  void setRegions(const regions::RegionMap* map);
  void regionSheetsChanged();
  void regionCellsChanged(const geometry::WorldRect& where);
  geometry::WorldRect regionBounds() const;
  /// The cell of a region at a point; nullopt if it is unknown or not fetched.
  std::optional<int> regionOccupancyAt(const Eigen::Vector2d& world_m) const;

 Q_SIGNALS:
  void settledChanged();
  void contentChanged();  // another map, or its end

 private:
  struct Sheet {
    std::unique_ptr<render::GridRenderer> renderer;
    RasterLayer* item = nullptr;
  };
  Sheet makeSheet();
  std::vector<const Sheet*> sheets() const;
  std::optional<render::PlacedGrid> placedOf(const session::MapSlot& slot) const;
  void syncSlot(const session::MapSlot& slot, Sheet& sheet);
  void syncDifference();
  void syncGrid(map::GridKind kind);

  const LayerContext& context_;
  render::RasterTiles::Options options_;
  session::Session* session_ = nullptr;
  MapTheme theme_;
  Sheet whole_, overview_, compared_, difference_;
  std::map<map::GridKind, Sheet> grids_;
  std::array<Sheet, regions::RegionCells::kMostSheets> region_sheets_;
  const regions::RegionMap* regions_ = nullptr;
  map::MapKey edited_map_;
  std::shared_ptr<const grids::GridPyramid> edited_;
};

}  // namespace mapwright::scene
