// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::robot::aimdk::fault {

using namespace mapwright::fault;  // what all rooms share

// Whole maps by remote calls.
/// whose robot it should be
inline constexpr FaultCode AnswerIsNoJson{
    "aimdk", QT_TRANSLATE_NOOP("aimdk", "The robot's answer is not JSON, so it may not be an %1 robot.")};
/// id, name, pixels
inline constexpr FaultCode PointOff{"aimdk",
                                    QT_TRANSLATE_NOOP("aimdk",
                                                      "Point %1 (%2): its pixel and metre coordinates differ "
                                                      "by %3 px. It is shown at its metre coordinates.")};
/// resolution
inline constexpr FaultCode ScaleInCentimetres{
    "aimdk",
    QT_TRANSLATE_NOOP("aimdk",
                      "Its resolution %1 was read as centimetres per pixel: only so do the pixels of "
                      "its points fit their metres.")};
/// resolution
inline constexpr FaultCode ScaleUntold{
    "aimdk",
    QT_TRANSLATE_NOOP("aimdk",
                      "Whether its resolution %1 means pixels per metre or centimetres per pixel cannot "
                      "be seen from its points. It was read as pixels per metre, as its maker says.")};
/// resolution
inline constexpr FaultCode ScaleFitsNeither{
    "aimdk",
    QT_TRANSLATE_NOOP(
        "aimdk",
        "The pixels of its points fit their metres neither if its resolution %1 means pixels per "
        "metre nor if it means centimetres per pixel: its picture may lie elsewhere. It was read as pixels "
        "per metre.")};
/// how many
inline constexpr FaultCode MorePointsOff{
    "aimdk", QT_TRANSLATE_N_NOOP("aimdk", "%1 more points have pixel and metre coordinates that differ.")};

/// how many
inline constexpr FaultCode PointsByPixels{
    "aimdk", QT_TRANSLATE_N_NOOP(
                 "aimdk", "%1 points have no metre coordinates. They are shown at their pixel coordinates.")};
/// how many
inline constexpr FaultCode PathsNotShown{"aimdk",
                                         QT_TRANSLATE_N_NOOP("aimdk", "%1 paths of this map are not shown.")};
/// how many
inline constexpr FaultCode RegionsNotShown{
    "aimdk", QT_TRANSLATE_N_NOOP("aimdk", "%1 regions of this map are not shown.")};
/// how many
inline constexpr FaultCode MapsWithoutId{
    "aimdk", QT_TRANSLATE_N_NOOP("aimdk", "%1 maps in the robot's list have no id. They were left out.")};

// What newer firmware has.
inline constexpr FaultCode MapsNotNow{"aimdk", QT_TRANSLATE_NOOP("aimdk", "The robot is not mapping.")};

// Waypoints that are changed.
/// name
inline constexpr FaultCode PointInTwoPlaces{
    "aimdk",
    QT_TRANSLATE_NOOP("aimdk",
                      "The pixels of %1 are not where its metres are: the robot might move it when it "
                      "is renamed. Move it first.")};
inline constexpr FaultCode PointScaleUntold{
    "aimdk",
    QT_TRANSLATE_NOOP("aimdk",
                      "The robot takes pixels, and the waypoints of this map do not show where its pixels "
                      "lie: a new one might land in the wrong place. Set some waypoints on the robot "
                      "itself first, apart from each other.")};
inline constexpr FaultCode PointsStay{
    "aimdk", QT_TRANSLATE_NOOP("aimdk", "Waypoints of this robot cannot be deleted from here.")};
inline constexpr FaultCode PointsWithoutTags{
    "aimdk", QT_TRANSLATE_NOOP("aimdk", "Waypoints of this robot cannot have tags.")};
/// name
inline constexpr FaultCode PointNotListed{
    "aimdk", QT_TRANSLATE_NOOP("aimdk", "The robot accepted the waypoint \"%1\", but does not list it.")};
/// name
inline constexpr FaultCode PointOtherwise{
    "aimdk",
    QT_TRANSLATE_NOOP("aimdk", "The robot accepted the change of \"%1\", but lists the waypoint otherwise.")};
/// name, metres
inline constexpr FaultCode PointElsewhere{
    "aimdk", QT_TRANSLATE_NOOP("aimdk",
                               "The robot accepted the waypoint \"%1\", but lists it %2 m from where it "
                               "should be.")};

// Topics of ROS that are asked for and silent.
/// host; because: why
inline constexpr FaultCode PoseSourceAway{
    "aimdk", QT_TRANSLATE_NOOP("aimdk",
                               "The rosbridge that provides the robot's pose cannot be reached at %1: %2. "
                               "Maps and waypoints work without it.")};

// What goes over the network. Hosts come with their ports.
/// because: how it answers
inline constexpr FaultCode NoAgibotRobotThere{
    "aimdk", QT_TRANSLATE_NOOP("aimdk",
                               "a web server answers there, but it does not know the requests of Agibot "
                               "robots (%1): check the address and the port")};

}  // namespace mapwright::robot::aimdk::fault
