#include "ui/replay/track_on_map.h"

#include <algorithm>

#include <QElapsedTimer>

#include "ui/shell/replay_clock.h"
#include "ui/view/track_of_bag.h"

namespace mapwright::ui {
namespace {

// For a long bag it takes a moment: the longer, the less often it is repeated while the bag is read.
constexpr int kSoonMs = 300, kTimesAsLong = 40, kAtMostMs = 10'000;

}  // namespace

TrackOnMap::TrackOnMap(ReplayClock& clock, scene::MapScene& scene, QObject* parent)
    : QObject(parent), clock_(clock), scene_(scene) {
  soon_.setSingleShot(true);
  soon_.setInterval(kSoonMs);
  connect(&soon_, &QTimer::timeout, this, &TrackOnMap::show);
  connect(&clock_, &ReplayClock::opened, this, &TrackOnMap::showSoon);
  connect(&clock_, &ReplayClock::rangesChanged, this, &TrackOnMap::showSoon);
  connect(&clock_, &ReplayClock::closed, this, [this] {
    soon_.stop();
    scene_.setTrack(nullptr);
  });
  connect(&scene_, &scene::MapScene::layersChanged, this, [this] {
    if (due_) showSoon();
  });
}

void TrackOnMap::showSoon() {
  if (!soon_.isActive()) soon_.start();
}

void TrackOnMap::show() {
  due_ = !scene_.layerVisible(scene::Layer::Track);
  if (due_ || !clock_.reading()) return;
  QElapsedTimer took;
  took.start();
  const std::shared_ptr<const scene::Track> track = trackOfBag(*clock_.reading());
  scene_.setTrack(track);
  geometry::WorldRect bounds;
  for (const scene::TrackSample& sample : *track) bounds.extend(sample.position_m);
  if (!bounds.empty()) Q_EMIT shown(bounds);
  soon_.setInterval(std::clamp(int(took.elapsed()) * kTimesAsLong, kSoonMs, kAtMostMs));
}

}  // namespace mapwright::ui

#include "moc_track_on_map.cpp"
