// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::robot::fault {

using namespace mapwright::fault;  // what all rooms share

// Whole maps.
/// robot::Capability, robot::Absence::Reason, then its arguments
inline constexpr FaultCode CapabilityLacking{"robot",
                                             QT_TRANSLATE_NOOP("robot", "The robot does not support that.")};

// The robot itself.
/// its words
inline constexpr FaultCode ItAnswered{"robot", QT_TRANSLATE_NOOP("robot", "It answered: %1")};

}  // namespace mapwright::robot::fault
