// Whether a robot sends the map that it works with by itself, and how.
#pragma once

#include "robot/map_dispatch.h"
#include "robot/robot.h"

namespace mapwright::robot {

/// One that does not is shown by one of the maps that it keeps.
inline bool sendsItsMap(Robot& robot) {
  LiveTopics* const live = robot.liveTopics();
  return live && !live->topicsOf(map::Stream::WholeMap).isEmpty();
}

/// It may be too large to be moved: its regions are asked for where somebody looks, and all of it is not
/// moved unasked.
inline bool givesByRegion(Robot& robot) {
  const MapDispatch* const dispatch = robot.mapDispatch();
  return dispatch && dispatch->offered(DispatchService::GridRegion);
}

}  // namespace mapwright::robot
