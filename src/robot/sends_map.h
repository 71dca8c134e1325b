// Whether a robot sends the map that it works with by itself.
#pragma once

#include "robot/robot.h"

namespace mapwright::robot {

/// One that does not is shown by one of the maps that it keeps.
inline bool sendsItsMap(Robot& robot) {
  LiveTopics* const live = robot.liveTopics();
  return live && !live->topicsOf(map::Stream::WholeMap).isEmpty();
}

}  // namespace mapwright::robot
