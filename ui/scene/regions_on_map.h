// The map by regions that lies on the map: where the scene keeps it.
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
  /// That of this scene; lives as long as it.
  static RegionsOnMap& of(const MapScene& scene);
  /// The scene makes one for itself.
  explicit RegionsOnMap(MapScene* scene);

  /// Not owned; null: none. It may go before this: then nothing is shown of it.
  void show(regions::RegionMap* map);
  regions::RegionMap* map() const { return map_; }

  /// Where the whole map lies, as its robot says; nullopt: it does not. Not looked at without a map.
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
