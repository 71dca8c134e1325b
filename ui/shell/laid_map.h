// A map that lies under the one on screen.
#pragma once

#include <string>

#include <QPointer>

#include "geometry/pose.h"
#include "map/catalogue.h"
#include "render/sample_grid.h"
#include "robot/robot.h"

namespace mapwright::ui {

struct LaidMap {
  render::PlacedGrid map;         // in its own coordinates
  geometry::Pose2 pose;           // where it lies on the map on screen
  QPointer<robot::Robot> reader;  // has its waypoints
  map::MapKey key;                // which of its maps it is
  std::string name;               // as it was read; empty: it has none
  bool operator==(const LaidMap& other) const {
    return map == other.map && pose == other.pose && reader == other.reader && key == other.key;
  }
};

}  // namespace mapwright::ui
