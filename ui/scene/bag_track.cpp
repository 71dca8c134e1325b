#include "scene/bag_track.h"

#include <utility>

namespace mapwright::scene {

BagTrack::BagTrack(MapScene* scene) : QObject(scene) {}

BagTrack& BagTrack::of(const MapScene& scene) {
  return *scene.findChild<BagTrack*>(QString(), Qt::FindDirectChildrenOnly);
}

void BagTrack::show(std::shared_ptr<const Track> track) {
  if (track == track_) return;
  track_ = std::move(track);
  Q_EMIT changed();
}

}  // namespace mapwright::scene

#include "moc_bag_track.cpp"
