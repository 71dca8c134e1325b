// Whether and how a robot sends its current map by itself.
#pragma once

#include "robot/map_dispatch.h"
#include "robot/robot.h"

namespace mapwright::robot {

/// If not, one of its stored maps is shown.
inline bool sendsItsMap(Robot& robot) {
  LiveTopics* const live = robot.liveTopics();
  return live && !live->topicsOf(map::Stream::WholeMap).isEmpty();
}

/// It may be too large to be sent whole: visible regions are requested, and all of it only on demand.
inline bool givesByRegion(Robot& robot) {
  const MapDispatch* const dispatch = robot.mapDispatch();
  return dispatch && dispatch->offered(DispatchService::GridRegion);
}

}  // namespace mapwright::robot
