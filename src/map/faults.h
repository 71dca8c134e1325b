// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::map::fault {

using namespace mapwright::fault;  // what all rooms share

// Where a grid lies.
inline constexpr FaultCode ResolutionNoNumber{
    "map", QT_TRANSLATE_NOOP("map", "Its resolution is not a number, so its position is unknown.")};
/// metres
inline constexpr FaultCode ResolutionNotPositive{
    "map", QT_TRANSLATE_NOOP("map", "Its resolution is %1, which is not a valid cell size.")};
/// metres
inline constexpr FaultCode ResolutionOutOfBounds{
    "map",
    QT_TRANSLATE_NOOP("map", "Its resolution of %1 m is out of range: it must be between 0.1 mm and 1 km.")};
inline constexpr FaultCode OriginNoNumber{
    "map", QT_TRANSLATE_NOOP("map", "Its origin is missing or not a number, so its position is unknown.")};

// The robot itself.
inline constexpr FaultCode EmergencyStop{
    "map", QT_TRANSLATE_NOOP("map", "It is pressed: the robot does not drive until it is released.")};

}  // namespace mapwright::map::fault
