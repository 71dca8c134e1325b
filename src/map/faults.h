// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::map::fault {

using namespace mapwright::fault;  // what all rooms share

// Where a grid lies.
inline constexpr FaultCode ResolutionNoNumber{
    "map", QT_TRANSLATE_NOOP("map", "Its resolution is not a number, so it cannot be placed.")};
/// metres
inline constexpr FaultCode ResolutionNotPositive{
    "map", QT_TRANSLATE_NOOP("map", "Its resolution is %1, which is no size of a cell.")};
/// metres
inline constexpr FaultCode ResolutionOutOfBounds{
    "map", QT_TRANSLATE_NOOP(
               "map", "Its resolution of %1 m is out of bounds: between 0.1 mm and 1 km can be shown.")};
inline constexpr FaultCode OriginNoNumber{
    "map", QT_TRANSLATE_NOOP("map", "Its origin is missing or not a number, so it cannot be placed.")};
inline constexpr FaultCode OriginTooFar{
    "map", QT_TRANSLATE_NOOP("map", "Its origin lies farther than 10,000 km away, so it cannot be placed.")};

// The robot itself.
inline constexpr FaultCode EmergencyStop{
    "map", QT_TRANSLATE_NOOP("map", "It is pressed: the robot does not drive until it is released.")};
inline constexpr FaultCode PositionLost{
    "map", QT_TRANSLATE_NOOP("map", "Where the robot stands on the map may be wrong.")};
inline constexpr FaultCode WheelsReleased{
    "map", QT_TRANSLATE_NOOP("map", "The robot can be pushed, and rolls on a slope.")};
inline constexpr FaultCode ManualControl{"map",
                                         QT_TRANSLATE_NOOP("map", "The robot does not drive by itself.")};
inline constexpr FaultCode PositionUncertain{
    "map", QT_TRANSLATE_NOOP("map", "The robot may stand beside its place on the map.")};
inline constexpr FaultCode WheelsSlipping{
    "map", QT_TRANSLATE_NOOP("map", "The robot may not be where its wheels say.")};
inline constexpr FaultCode AlertWithoutText{"map",
                                            QT_TRANSLATE_NOOP("map", "The robot gives no text with it.")};

}  // namespace mapwright::map::fault
