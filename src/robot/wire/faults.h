// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::robot::wire::fault {

using namespace mapwright::fault;  // what all rooms share

// Whole maps.
/// how many
inline constexpr FaultCode RowsWithoutId{"wire",
                                         QT_TRANSLATE_N_NOOP("wire", "%1 rows without an id were left out.")};
inline constexpr FaultCode AnswerIsNoMap{"wire",
                                         QT_TRANSLATE_NOOP("wire", "the robot's answer is not a map")};

// Whole maps by remote calls.
inline constexpr FaultCode PointsAreNoList{
    "wire", QT_TRANSLATE_NOOP("wire", "The robot's list of points is not a list.")};
/// how many
inline constexpr FaultCode PointsUnplaced{
    "wire", QT_TRANSLATE_N_NOOP("wire", "%1 points without a position were left out.")};

// Map files.
/// id
inline constexpr FaultCode WaypointIdTwice{"wire",
                                           QT_TRANSLATE_NOOP("wire", "Two waypoints have the id %1.")};

// Changing maps.
inline constexpr FaultCode StillListed{
    "wire", QT_TRANSLATE_NOOP("wire", "The robot accepted the deletion, but still lists the map.")};
inline constexpr FaultCode NotListedYet{
    "wire", QT_TRANSLATE_NOOP("wire", "The robot accepted the new map, but does not list it.")};
inline constexpr FaultCode NotMapping{
    "wire", QT_TRANSLATE_NOOP("wire", "The robot accepted it, but is not mapping.")};
inline constexpr FaultCode MapsAlready{
    "wire", QT_TRANSLATE_NOOP("wire", "The robot is mapping already. Stop or discard that mapping first.")};
inline constexpr FaultCode StillMapping{
    "wire", QT_TRANSLATE_NOOP("wire", "The robot accepted it, but is still mapping.")};

// Live messages.
inline constexpr FaultCode PointsWithoutFields{
    "wire", QT_TRANSLATE_NOOP("wire", "It has no fields x and y, or their type is unknown.")};

}  // namespace mapwright::robot::wire::fault
