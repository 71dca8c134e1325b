// Overlays as the map shows them during editing.
#pragma once

#include <vector>

#include "map/catalogue.h"
#include "map/overlay.h"

namespace mapwright::ui::scene {

/// The overlays of one map, shown instead of those that came with it.
struct DrawnOverlays {
  map::MapKey map;
  bool robots = false;  // the robot is in that map: they are its present ones, too
  std::vector<map::OverlayFeature> features;
};

}  // namespace mapwright::ui::scene
