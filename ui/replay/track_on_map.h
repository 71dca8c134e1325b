// Shows the robot's path through the bag on the map, as far as it has been read. GUI-thread object.
#pragma once

#include <QObject>
#include <QTimer>

#include "geometry/rect.h"
#include "ui/scene/map_scene.h"

namespace mapwright::ui {

class ReplayClock;

class TrackOnMap : public QObject {
  Q_OBJECT
 public:
  /// Both outlive it.
  TrackOnMap(ReplayClock& clock, scene::MapScene& scene, QObject* parent = nullptr);

 Q_SIGNALS:
  /// Of the path as it is shown now; never empty.
  void shown(const mapwright::geometry::WorldRect& bounds);

 private:
  void showSoon();
  void show();

  ReplayClock& clock_;
  scene::MapScene& scene_;
  QTimer soon_;
  bool due_ = false;  // hidden meanwhile
};

}  // namespace mapwright::ui
