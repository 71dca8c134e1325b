// The words of what is odd about a ROS robot: its messages, frames and topics, and KABAM's map manager.
#pragma once

#include <QString>

#include "map/reason.h"

namespace mapwright::sentences {

/// With places for the arguments; null = a code of another group.
QString ofRos(map::ReasonCode code, int count);

}  // namespace mapwright::sentences
