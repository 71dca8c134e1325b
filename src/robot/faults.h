// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::robot::fault {

using namespace mapwright::fault;  // what all rooms share

// Whole maps.
/// robot::Capability, robot::Absence::Reason, then its arguments
inline constexpr FaultCode CapabilityLacking{"robot",
                                             QT_TRANSLATE_NOOP("robot", "The robot does not support that.")};
/// how many
inline constexpr FaultCode FeaturesUnreadable{
    "robot", QT_TRANSLATE_N_NOOP("robot", "%1 features of its overlays cannot be read.")};

// The robot itself.
/// its words
inline constexpr FaultCode ItAnswered{"robot", QT_TRANSLATE_NOOP("robot", "It answered: %1")};

// Waypoints that are changed.
/// name
inline constexpr FaultCode WaypointNameTaken{
    "robot",
    QT_TRANSLATE_NOOP("robot", "another waypoint of this map is called \"%1\", too; rename one of the two")};

// A map dispatcher.
inline constexpr FaultCode ProjectionsNotTold{
    "robot", QT_TRANSLATE_NOOP(
                 "robot",
                 "Its projections are unknown: it does not list its topics and services (its node rosapi is "
                 "not running), and nothing has arrived on the usual topics (projected_map_0 and so on).")};

// Bags.
/// path; because: why
inline constexpr FaultCode BagFileNotWritten{"robot", QT_TRANSLATE_NOOP("robot", "%1 cannot be written: %2")};

}  // namespace mapwright::robot::fault
