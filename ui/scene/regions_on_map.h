// The map by regions in the scene.
#pragma once

#include <optional>

#include <QObject>
#include <QPointer>

#include "map/grid_reference.h"
#include "regions/region_map.h"
#include "scene/map_scene.h"

namespace mapwright::scene {

class RegionsOnMap : public QObject {
  Q_OBJECT
 public:
  /// The one of this scene; lives as long as it.
  static RegionsOnMap& of(const MapScene& scene);
  /// Made by the scene itself.
  explicit RegionsOnMap(MapScene* scene);

  /// Not owned; null: none. It may be destroyed first: then nothing of it is shown.
  void show(regions::RegionMap* map);
  regions::RegionMap* map() const { return map_; }

  /// The extent of the whole map as reported by its robot; nullopt: not reported. Ignored without a map.
  void setExtent(const std::optional<map::GridReference>& extent);
  const std::optional<map::GridReference>& extent() const { return extent_; }

 Q_SIGNALS:
  void shownChanged();  // another one, or none
  void extentChanged();
  void regionsChanged();  // how its regions stand
  void sheetsChanged();
  void cellsChanged(const mapwright::geometry::WorldRect& where);

 private:
  QPointer<regions::RegionMap> map_;
  std::optional<map::GridReference> extent_;
};

}  // namespace mapwright::scene
