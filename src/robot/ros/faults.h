// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::robot::ros::fault {

using namespace mapwright::fault;  // what all rooms share

// Messages of ROS.
/// field
inline constexpr FaultCode RosFieldMissing{
    "ros", QT_TRANSLATE_NOOP("ros", "Its field %1 is missing or cannot be read.")};
/// field, its value
inline constexpr FaultCode RosFieldWrong{"ros",
                                         QT_TRANSLATE_NOOP("ros", "Its field %1 is %2, which is not valid.")};
/// field, how many it holds, how many are needed
inline constexpr FaultCode RosLengthDiffers{
    "ros", QT_TRANSLATE_NOOP(
               "ros", "Its field %1 has %2 values, but according to its other fields it should have %3.")};
/// bytes of a row, bytes of its points
inline constexpr FaultCode RosRowsHoldMore{
    "ros", QT_TRANSLATE_NOOP("ros",
                             "Its rows are %1 bytes long (row_step), but its points take %2 of them (width "
                             "and point_step). The remaining bytes are ignored.")};
/// width, height
inline constexpr FaultCode RosGridEmpty{"ros", QT_TRANSLATE_NOOP("ros", "It has no cells: it is %1 x %2.")};
inline constexpr FaultCode RosTurnIsZero{
    "ros", QT_TRANSLATE_NOOP(
               "ros", "Its orientation is not a rotation (a zero quaternion). It is shown with yaw 0.")};
/// its width and height, x and y, width and height of the grid
inline constexpr FaultCode RosPatchOutside{
    "ros",
    QT_TRANSLATE_NOOP(
        "ros", "An update of %1 x %2 cells at %3, %4 does not fit into its %5 x %6 cells. It was left out.")};
/// how many came, of which each n-th is shown
inline constexpr FaultCode RosPointsThinned{
    "ros", QT_TRANSLATE_NOOP("ros", "It has %1 points, too many to draw. One in %2 is shown.")};
/// its frame, that of the grid
inline constexpr FaultCode RosPatchInOtherFrame{
    "ros",
    QT_TRANSLATE_NOOP(
        "ros",
        "An update of it is in the frame %1, but the map is in the frame %2. The update was left out.")};

// Where the frames of ROS lie to each other.
/// frame
inline constexpr FaultCode RosFrameUnknown{
    "ros",
    QT_TRANSLATE_NOOP(
        "ros", "The robot has not sent a transform for the frame %1 yet, so its position is unknown.")};
/// frame, the other one
inline constexpr FaultCode RosFramesApart{
    "ros", QT_TRANSLATE_NOOP(
               "ros", "No transforms connect the frame %1 to the frame %2, so its position is unknown.")};
/// frame
inline constexpr FaultCode RosFrameAlone{
    "ros", QT_TRANSLATE_NOOP("ros",
                             "Neither a map nor a transform gives the position of the frame %1. Everything "
                             "is shown in that frame, as if the robot never moved.")};
/// how many; because: why the first cannot
inline constexpr FaultCode RosMarkersUnplaced{"ros",
                                              QT_TRANSLATE_N_NOOP("ros", "%1 markers cannot be placed")};
/// how many, the file of the first
inline constexpr FaultCode RosMeshesAsSpots{
    "ros", QT_TRANSLATE_N_NOOP(
               "ros", "%1 markers are meshes (%2), which are not read: spots are drawn in their places.")};
/// how many
inline constexpr FaultCode RosMarkersUnknown{
    "ros", QT_TRANSLATE_N_NOOP("ros", "%1 markers are of an unknown kind and are not drawn.")};
/// how many
inline constexpr FaultCode RosMarkersLeftOut{
    "ros", QT_TRANSLATE_N_NOOP(
               "ros", "%1 markers are left out or cut: they cannot be read, or there are too many.")};
/// their namespaces
inline constexpr FaultCode RosSeveralRobots{
    "ros", QT_TRANSLATE_NOOP("ros",
                             "There are several robots: %1. Add ?ns=/NAMESPACE to the address to see one of "
                             "them alone.")};
/// child, parent
inline constexpr FaultCode RosTransformTooOld{
    "ros", QT_TRANSLATE_NOOP("ros",
                             "It is older than the transforms from %1 to %2 that are kept, so its position "
                             "is unknown. The clocks of the robot may differ.")};
/// child, parent
inline constexpr FaultCode RosTransformTooNew{
    "ros", QT_TRANSLATE_NOOP("ros",
                             "It is newer than the last transform from %1 to %2, so its position is unknown. "
                             "The node that sends this transform may be late or have stopped.")};
/// child, parent
inline constexpr FaultCode RosTransformLoop{
    "ros", QT_TRANSLATE_NOOP("ros",
                             "A transform from %1 to %2 would close a loop of frames and was left out: two "
                             "nodes of the robot contradict each other.")};

// Topics of ROS that are asked for and silent.
/// because: what is known of why
inline constexpr FaultCode TopicSilent{
    "ros", QT_TRANSLATE_NOOP("ros", "Waiting: nothing arrives on this topic now")};
inline constexpr FaultCode TopicNotListed{"ros",
                                          QT_TRANSLATE_NOOP("ros", "the robot does not have this topic now")};
inline constexpr FaultCode TopicNobodySends{
    "ros", QT_TRANSLATE_NOOP("ros", "the topic exists, but no node of the robot publishes it")};
inline constexpr FaultCode TopicsNotTold{
    "ros",
    QT_TRANSLATE_NOOP(
        "ros",
        "the robot does not list its topics (its node rosapi is not running), so it may not have this one")};
inline constexpr FaultCode TopicListedOnly{
    "ros", QT_TRANSLATE_NOOP("ros",
                             "the topic exists; it may have nothing to send now, or the rosbridge server may "
                             "lack its message type")};
/// the service that was asked for it
inline constexpr FaultCode TopicAskedInstead{
    "ros", QT_TRANSLATE_NOOP("ros",
                             "Nothing has arrived on this topic. The map was requested from the service %1 "
                             "and is shown as it was then.")};
/// service; because: why
inline constexpr FaultCode MapServiceFailed{
    "ros",
    QT_TRANSLATE_NOOP("ros", "The service %1 did not provide the map either: %2. It will be called again.")};

// What a map dispatcher is not asked, or does not tell.
inline constexpr FaultCode RegionMeansNothing{
    "ros", QT_TRANSLATE_NOOP("ros",
                             "Nothing was sent to the robot: the position and size of a region must be "
                             "numbers, and the size greater than 0 m.")};
inline constexpr FaultCode FileNameMeansNothing{
    "ros", QT_TRANSLATE_NOOP("ros",
                             "Nothing was sent to the robot: a file name must have 1 to 4,096 bytes, without "
                             "line breaks or other control characters.")};
inline constexpr FaultCode ProjectionMeansNothing{
    "ros",
    QT_TRANSLATE_NOOP("ros",
                      "Nothing was sent to the robot: the position and heights of a projection must be "
                      "numbers, its size greater than 0 m, and its lower height below the upper one.")};

inline constexpr FaultCode WholeMapNotFetched{
    "ros", QT_TRANSLATE_NOOP(
               "ros", "The robot sends this map by region, and the whole map has not been loaded yet.")};

// A manager of maps (KABAM).
inline constexpr FaultCode NoAnswerInTime{"ros",
                                          QT_TRANSLATE_NOOP("ros", "the robot did not answer in time")};
inline constexpr FaultCode LinkBrokeOff{"ros", QT_TRANSLATE_NOOP("ros", "the connection was lost")};
inline constexpr FaultCode AnswerWithoutResult{"ros",
                                               QT_TRANSLATE_NOOP("ros", "the answer contains no result")};
inline constexpr FaultCode ResultMapUnknown{"ros", QT_TRANSLATE_NOOP("ros", "it has no such map")};
inline constexpr FaultCode ResultUndefined{"ros", QT_TRANSLATE_NOOP("ros", "it failed without saying why")};
inline constexpr FaultCode ResultInvalid{"ros", QT_TRANSLATE_NOOP("ros", "it considers the request invalid")};
/// name
inline constexpr FaultCode ResultMapNameTaken{
    "ros", QT_TRANSLATE_NOOP("ros", "another map is already called \"%1\"; choose another name")};
/// its code
inline constexpr FaultCode ResultUnknown{
    "ros", QT_TRANSLATE_NOOP("ros", "the answer %1 is unknown to this program")};
/// seconds
inline constexpr FaultCode NotConfirmed{
    "ros",
    QT_TRANSLATE_NOOP(
        "ros",
        "not confirmed: the robot reported success, but did not show the change within %1 s. Check again")};
/// name
inline constexpr FaultCode TagsNotTaken{
    "ros", QT_TRANSLATE_NOOP("ros",
                             "The robot accepted the change of \"%1\", but not its tags. To remove its last "
                             "tag, delete the waypoint and create it again.")};
/// name
inline constexpr FaultCode ChangedMeanwhile{
    "ros", QT_TRANSLATE_NOOP("ros", "\"%1\" was changed on the robot in the meantime")};
inline constexpr FaultCode OnlyCurrentMapSent{
    "ros",
    QT_TRANSLATE_NOOP("ros", "The robot only sends its current map. Load this one on the robot to see it.")};
inline constexpr FaultCode OnlyCurrentMapTaken{
    "ros", QT_TRANSLATE_NOOP("ros",
                             "The robot only sends its current map, so only that picture can be saved and "
                             "compared. Nothing was sent. Load this map on the robot first.")};
/// the cell, of 100
inline constexpr FaultCode CellBetweenKinds{
    "ros",
    QT_TRANSLATE_NOOP(
        "ros",
        "Some of its cells are neither free, occupied nor unknown but in between (%1 of 100), and the map "
        "manager has no gray level for these. Nothing was sent. Export the map to edit it as files.")};
/// how many cells
inline constexpr FaultCode PictureShownOtherwise{
    "ros", QT_TRANSLATE_N_NOOP(
               "ros", "The robot accepted the picture, but shows %1 cells differently. Compare the two.")};
inline constexpr FaultCode MessageNotUnderstood{
    "ros", QT_TRANSLATE_NOOP("ros", "The message does not have the expected fields. It was left out.")};
/// name
inline constexpr FaultCode WaypointTurnIsZero{
    "ros", QT_TRANSLATE_NOOP("ros",
                             "Waypoint \"%1\" has no heading (a zero quaternion). It is shown with yaw 0, "
                             "and kept unchanged until you turn it.")};
/// because: why
inline constexpr FaultCode WaypointsNotConfirmed{
    "ros",
    QT_TRANSLATE_NOOP("ros",
                      "This list may be out of date: it comes from a topic, and the map manager did not "
                      "confirm it (get_waypoint)")};
/// name, frame
inline constexpr FaultCode WaypointFrameUnknown{
    "ros", QT_TRANSLATE_NOOP("ros",
                             "Waypoint \"%1\" is in the frame %2, and the frame of the map is not known yet. "
                             "It is assumed to be on the map.")};

// What goes over the network. Hosts come with their ports.
/// host
inline constexpr FaultCode NoMapManagerThere{
    "ros", QT_TRANSLATE_NOOP("ros",
                             "there is a rosbridge server at %1, but its robot has no KABAM map manager "
                             "(/map_manager). Start it, or connect to ros+ws:// to use everything else.")};

}  // namespace mapwright::robot::ros::fault
