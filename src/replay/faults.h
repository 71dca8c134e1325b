// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::replay::fault {

using namespace mapwright::fault;  // what all rooms share

/// because: each BagPartRefused
inline constexpr FaultCode BagPartsRefused{"replay", QT_TRANSLATE_NOOP("replay", "Not all of it can be read"),
                                           FaultCode::Causes::Continued};
/// from when, until when; because: why
inline constexpr FaultCode BagPartRefused{"replay", QT_TRANSLATE_NOOP("replay", "%1 to %2 is missing"),
                                          FaultCode::Causes::Continued};
/// its status; because: its words
inline constexpr FaultCode RobotAnswered{"replay", QT_TRANSLATE_NOOP("replay", "the robot answered %1"),
                                         FaultCode::Causes::Continued};
/// how many
inline constexpr FaultCode BagPartsMore{"replay", QT_TRANSLATE_NOOP("replay", "and more parts: %1")};

}  // namespace mapwright::replay::fault
