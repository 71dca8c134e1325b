// The private members of a MapScene. Private to this room.
#pragma once

#include <QElapsedTimer>
#include <QTimer>

#include "scene/map_scene.h"
#include "scene/repaint_pace.h"
#include "scene/scene_items.h"

namespace mapwright::scene {

class MapScene::Impl : public SceneItems {
 public:
  using SceneItems::SceneItems;

  RepaintPace pace;
  QElapsedTimer clock;
  QTimer repaint_timer;  // runs while new tiles wait to be painted
  double began_ms = 0;   // of the painting in progress
  double nowMs() const { return double(clock.nsecsElapsed()) * 1e-6; }
};

}  // namespace mapwright::scene
