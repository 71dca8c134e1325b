// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::replay::fault {

using namespace mapwright::fault;  // what all rooms share

/// its status; because: its words
inline constexpr FaultCode RobotAnswered{"replay", QT_TRANSLATE_NOOP("replay", "the robot answered %1"),
                                         FaultCode::Causes::Continued};

}  // namespace mapwright::replay::fault
