// A map whose picture the robot does not send: everything else known about it is still available.
#pragma once

#include "robot/sends_map.h"
#include "session/map_slot.h"

namespace mapwright::session {

/// The slot requested a stored map, and its picture is not available.
inline bool lacksPicture(const MapSlot& slot) {
  return slot.phase() == MapSlot::Phase::Failed && slot.failure() == map::FailureKind::Unsupported &&
         slot.key().kind == map::MapKind::Stored && !slot.cells();
}

/// Nothing was requested: the robot's current map is loaded by region.
inline bool isByRegion(robot::Robot& robot, const MapSlot& slot) {
  return slot.phase() == MapSlot::Phase::Empty && !slot.cells() && robot::givesByRegion(robot);
}

}  // namespace mapwright::session
