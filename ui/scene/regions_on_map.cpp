#include "scene/regions_on_map.h"

namespace mapwright::scene {

using regions::RegionMap;

RegionsOnMap::RegionsOnMap(MapScene* scene) : QObject(scene) {}

RegionsOnMap& RegionsOnMap::of(const MapScene& scene) {
  return *scene.findChild<RegionsOnMap*>(QString(), Qt::FindDirectChildrenOnly);
}

void RegionsOnMap::show(RegionMap* map) {
  if (map == map_) return;
  if (map_) map_->disconnect(this);
  map_ = map;
  if (map_) {
    connect(map_, &RegionMap::changed, this, &RegionsOnMap::regionsChanged);
    connect(map_, &RegionMap::sheetsChanged, this, &RegionsOnMap::sheetsChanged);
    connect(map_, &RegionMap::cellsChanged, this, &RegionsOnMap::cellsChanged);
    connect(map_, &QObject::destroyed, this, &RegionsOnMap::shownChanged);
  }
  Q_EMIT shownChanged();
}

}  // namespace mapwright::scene
