// A map that a robot has and sends no picture of: what else is known of it can be had all the same.
#pragma once

#include "robot/sends_map.h"
#include "session/map_slot.h"

namespace mapwright::session {

/// The slot asked for a stored map, and was told that there is no picture of it to be had.
inline bool lacksPicture(const MapSlot& slot) {
  return slot.phase() == MapSlot::Phase::Failed && slot.failure() == map::FailureKind::Unsupported &&
         slot.key().kind == map::MapKind::Stored && !slot.cells();
}

/// Nothing was asked for: the map that the robot works with is seen by regions.
inline bool isByRegion(robot::Robot& robot, const MapSlot& slot) {
  return slot.phase() == MapSlot::Phase::Empty && !slot.cells() && robot::givesByRegion(robot);
}

}  // namespace mapwright::session
