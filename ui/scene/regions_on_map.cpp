#include "scene/regions_on_map.h"

#include <utility>

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

void RegionsOnMap::setExtent(const std::optional<map::GridReference>& extent) {
  if (std::exchange(extent_, extent) != extent) Q_EMIT extentChanged();
}

}  // namespace mapwright::scene

#include "moc_regions_on_map.cpp"
