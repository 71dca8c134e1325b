// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::robot::aimdk::fault {

using namespace mapwright::fault;  // what all rooms share

// Whole maps.
/// width and height of the picture, width and height as the robot says
inline constexpr FaultCode SizesDisagree{
    "aimdk",
    QT_TRANSLATE_NOOP(
        "aimdk",
        "Its picture has %1 x %2 cells, but the robot says %3 x %4. Placed by the picture's own size.")};

// Whole maps by remote calls.
/// whose robot it should be
inline constexpr FaultCode AnswerIsNoJson{
    "aimdk", QT_TRANSLATE_NOOP("aimdk", "The robot's answer is not JSON, so it may not be an %1 robot.")};
inline constexpr FaultCode AnswerHoldsNoData{"aimdk", QT_TRANSLATE_NOOP("aimdk", "its answer holds no data")};
inline constexpr FaultCode MapsAreNoList{
    "aimdk", QT_TRANSLATE_NOOP("aimdk", "The robot's list of maps is not a list.")};
inline constexpr FaultCode ScaleNotPositive{
    "aimdk",
    QT_TRANSLATE_NOOP("aimdk",
                      "Its resolution is missing or not above 0 pixels per metre, so it cannot be placed.")};
/// its id
inline constexpr FaultCode WrongMapSent{
    "aimdk", QT_TRANSLATE_NOOP("aimdk", "The robot sent the map %1 instead of it.")};
inline constexpr FaultCode NoPictureOfItSent{"aimdk",
                                             QT_TRANSLATE_NOOP("aimdk", "The robot sent no picture of it.")};
inline constexpr FaultCode PictureNotBase64{
    "aimdk", QT_TRANSLATE_NOOP("aimdk", "Its picture is not base64, or larger than 256 MB.")};
inline constexpr FaultCode HeightNotSaid{
    "aimdk",
    QT_TRANSLATE_NOOP("aimdk", "Its picture is not a PNG, and the robot does not say how high it is.")};
/// id, name, pixels
inline constexpr FaultCode PointOff{
    "aimdk",
    QT_TRANSLATE_NOOP("aimdk",
                      "Point %1 (%2): its pixels lie %3 px from its metres. Shown where its metres say.")};
/// how many
inline constexpr FaultCode MorePointsOff{
    "aimdk", QT_TRANSLATE_N_NOOP("aimdk", "%1 points more disagree with their pixels.")};

// Topics of ROS that are asked for and silent.
/// host; because: why
inline constexpr FaultCode PoseSourceAway{
    "aimdk", QT_TRANSLATE_NOOP("aimdk",
                               "The rosbridge that tells where the robot is cannot be reached at %1: %2. "
                               "Maps and waypoints come all the same.")};

// What goes over the network. Hosts come with their ports.
/// because: how it answers
inline constexpr FaultCode NoAgibotRobotThere{
    "aimdk", QT_TRANSLATE_NOOP("aimdk",
                               "a web server answers there, but it knows no calls of Agibot robots (%1): "
                               "check the address and the port")};

}  // namespace mapwright::robot::aimdk::fault
