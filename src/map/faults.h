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
inline constexpr FaultCode OriginTooFar{
    "map", QT_TRANSLATE_NOOP("map", "Its origin is more than 10,000 km away, so it cannot be shown.")};

// The robot itself.
inline constexpr FaultCode EmergencyStop{
    "map", QT_TRANSLATE_NOOP("map", "It is pressed: the robot does not drive until it is released.")};
inline constexpr FaultCode PositionLost{
    "map", QT_TRANSLATE_NOOP("map", "The position of the robot on the map may be wrong.")};
inline constexpr FaultCode WheelsReleased{
    "map",
    QT_TRANSLATE_NOOP("map", "The wheels are released: the robot can be pushed and may roll on a slope.")};
inline constexpr FaultCode ManualControl{"map",
                                         QT_TRANSLATE_NOOP("map", "The robot does not drive on its own.")};
inline constexpr FaultCode PositionUncertain{
    "map", QT_TRANSLATE_NOOP("map", "The robot may be off its position on the map.")};
inline constexpr FaultCode WheelsSlipping{
    "map", QT_TRANSLATE_NOOP("map", "The robot may not be where its odometry says.")};
inline constexpr FaultCode AlertWithoutText{"map",
                                            QT_TRANSLATE_NOOP("map", "The robot gives no further text.")};

}  // namespace mapwright::map::fault
