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
                                         QT_TRANSLATE_NOOP("ros", "Its field %1 is %2, which cannot be.")};
/// field, how many it holds, how many are needed
inline constexpr FaultCode RosLengthDiffers{
    "ros", QT_TRANSLATE_NOOP("ros", "Its field %1 holds %2 values, but its other fields say %3.")};
/// bytes of a row, bytes of its points
inline constexpr FaultCode RosRowsHoldMore{
    "ros", QT_TRANSLATE_NOOP("ros",
                             "Its rows are %1 bytes long (row_step), but its points fill %2 of them (width "
                             "and point_step). What lies behind them is left out.")};
/// width, height
inline constexpr FaultCode RosGridEmpty{"ros", QT_TRANSLATE_NOOP("ros", "It has no cells: it is %1 x %2.")};
inline constexpr FaultCode RosTurnIsZero{
    "ros",
    QT_TRANSLATE_NOOP("ros", "Its orientation is no rotation (a zero quaternion). It is shown with yaw 0.")};
/// its width and height, x and y, width and height of the grid
inline constexpr FaultCode RosPatchOutside{
    "ros",
    QT_TRANSLATE_NOOP(
        "ros", "An update of %1 x %2 cells at %3, %4 does not lie in its %5 x %6 cells. It was left out.")};
/// how many came, of which each n-th is shown
inline constexpr FaultCode RosPointsThinned{
    "ros", QT_TRANSLATE_NOOP("ros", "It has %1 points, too many to be drawn. One of every %2 is shown.")};
/// its frame, that of the grid
inline constexpr FaultCode RosPatchInOtherFrame{
    "ros",
    QT_TRANSLATE_NOOP(
        "ros",
        "An update of it lies in the frame %1, but it lies in the frame %2. The update was left out.")};
/// because: what became of the second
inline constexpr FaultCode RosOneConnection{
    "ros", QT_TRANSLATE_NOOP("ros",
                             "The rosbridge server takes no second connection: %1. Maps and clouds share the "
                             "one that poses come by, so these may come late while a map is sent.")};

// Where the frames of ROS lie to each other.
/// frame
inline constexpr FaultCode RosFrameUnknown{
    "ros",
    QT_TRANSLATE_NOOP("ros", "The robot has sent no transform of the frame %1 yet, so it cannot be placed.")};
/// frame, the other one
inline constexpr FaultCode RosFramesApart{
    "ros",
    QT_TRANSLATE_NOOP("ros", "No transforms connect the frame %1 to the frame %2, so it cannot be placed.")};
/// frame
inline constexpr FaultCode RosFrameAlone{
    "ros", QT_TRANSLATE_NOOP("ros",
                             "Neither a map nor a transform tells where the frame %1 lies. It is shown as "
                             "seen from there, as if the robot never moved.")};
/// child, parent
inline constexpr FaultCode RosTransformTooOld{
    "ros", QT_TRANSLATE_NOOP("ros",
                             "It is older than the transforms of %1 in %2 that are kept, so it cannot be "
                             "placed. The clocks of the robot may differ.")};
/// child, parent
inline constexpr FaultCode RosTransformTooNew{
    "ros", QT_TRANSLATE_NOOP("ros",
                             "It is newer than the last transform of %1 in %2, so it cannot be placed. "
                             "Whoever sends that transform may be late, or may have stopped.")};
/// child, parent
inline constexpr FaultCode RosTransformLoop{
    "ros", QT_TRANSLATE_NOOP("ros",
                             "A transform of %1 in %2 would close a loop of frames. It was left out: two "
                             "nodes of the robot contradict each other.")};

// Topics of ROS that are asked for and silent.
/// because: what is known of why
inline constexpr FaultCode TopicSilent{"ros", QT_TRANSLATE_NOOP("ros", "Waiting: nothing comes by it now")};
inline constexpr FaultCode TopicNotListed{"ros",
                                          QT_TRANSLATE_NOOP("ros", "the robot knows no such topic now")};
inline constexpr FaultCode TopicNobodySends{
    "ros", QT_TRANSLATE_NOOP("ros", "the topic is there, but no node of the robot sends anything by it")};
inline constexpr FaultCode TopicsNotTold{
    "ros",
    QT_TRANSLATE_NOOP(
        "ros",
        "the robot does not tell which topics it has (its node rosapi does not run), so it may not have it")};
inline constexpr FaultCode TopicListedOnly{
    "ros",
    QT_TRANSLATE_NOOP(
        "ros",
        "the topic is there; it may have nothing to say now, or the rosbridge server may lack its type")};
/// the service that was asked for it
inline constexpr FaultCode TopicAskedInstead{
    "ros", QT_TRANSLATE_NOOP("ros",
                             "Nothing has come by it. Its map has been asked for by the service %1, and is "
                             "shown as it was then.")};
/// service; because: why
inline constexpr FaultCode MapServiceFailed{
    "ros", QT_TRANSLATE_NOOP(
               "ros", "The map could not be had by the service %1 either: %2. It will be asked for again.")};

// What a map dispatcher is not asked, or does not tell.
inline constexpr FaultCode RegionMeansNothing{
    "ros", QT_TRANSLATE_NOOP("ros",
                             "The robot has not been asked: a region needs a place and a size that are "
                             "numbers, and a size of more than 0 m.")};
inline constexpr FaultCode FileNameMeansNothing{
    "ros", QT_TRANSLATE_NOOP("ros",
                             "The robot has not been asked: the name of a file needs one to 4,096 bytes, and "
                             "no line ends or other control characters.")};
inline constexpr FaultCode ProjectionMeansNothing{
    "ros", QT_TRANSLATE_NOOP("ros",
                             "The robot has not been asked: a projection needs a place and heights that are "
                             "numbers, a size of more than 0 m, and its lower height below the upper one.")};
inline constexpr FaultCode ProjectionsNotTold{
    "ros",
    QT_TRANSLATE_NOOP(
        "ros",
        "What it projects cannot be told: it does not say which topics and services it has (its node rosapi "
        "does not run), and nothing has come by the usual topics (projected_map_0 and so on).")};

// A manager of maps (KABAM).
inline constexpr FaultCode NoAnswerInTime{"ros",
                                          QT_TRANSLATE_NOOP("ros", "the robot did not answer in time")};
inline constexpr FaultCode LinkBrokeOff{"ros", QT_TRANSLATE_NOOP("ros", "the connection broke off")};
inline constexpr FaultCode NotConnected{"ros",
                                        QT_TRANSLATE_NOOP("ros", "there is no connection to the robot")};
inline constexpr FaultCode AnswerWithoutResult{"ros", QT_TRANSLATE_NOOP("ros", "its answer holds no result")};
inline constexpr FaultCode ResultMapUnknown{"ros", QT_TRANSLATE_NOOP("ros", "it has no such map")};
/// name
inline constexpr FaultCode ResultNameTaken{
    "ros",
    QT_TRANSLATE_NOOP(
        "ros", "another waypoint of this map is called \"%1\", too; give one of the two another name")};
inline constexpr FaultCode ResultWaypointUnknown{
    "ros", QT_TRANSLATE_NOOP("ros", "it has no such waypoint any more")};
inline constexpr FaultCode ResultUndefined{"ros",
                                           QT_TRANSLATE_NOOP("ros", "it failed, and does not say why")};
inline constexpr FaultCode ResultInvalid{"ros", QT_TRANSLATE_NOOP("ros", "it takes the request for invalid")};
inline constexpr FaultCode ResultInvalidLoad{
    "ros",
    QT_TRANSLATE_NOOP(
        "ros", "it takes the request for invalid; it may want to be told at which waypoint it stands")};
inline constexpr FaultCode ResultAlreadyLoaded{"ros",
                                               QT_TRANSLATE_NOOP("ros", "it works with this map already")};
inline constexpr FaultCode ResultNothingToSave{
    "ros",
    QT_TRANSLATE_NOOP(
        "ros", "it takes the request for invalid; there may be nothing to save, or the name may not do")};
/// name
inline constexpr FaultCode ResultMapNameTaken{
    "ros", QT_TRANSLATE_NOOP("ros", "another map is called \"%1\" already; choose another name")};
/// its code
inline constexpr FaultCode ResultUnknown{"ros",
                                         QT_TRANSLATE_NOOP("ros", "%1 is no answer that this program knows")};
/// seconds
inline constexpr FaultCode NotConfirmed{
    "ros",
    QT_TRANSLATE_NOOP(
        "ros",
        "not confirmed: the robot said that it was done, but did not show it within %1 s. Look again")};
/// name
inline constexpr FaultCode TagsNotTaken{
    "ros", QT_TRANSLATE_NOOP("ros",
                             "The robot has taken the change of \"%1\", but not its tags. To be rid of its "
                             "last tag, delete the waypoint and create it anew.")};
/// name
inline constexpr FaultCode ChangedMeanwhile{
    "ros", QT_TRANSLATE_NOOP("ros", "\"%1\" has been changed on the robot meanwhile")};
inline constexpr FaultCode ListsNotTold{
    "ros", QT_TRANSLATE_NOOP("ros", "the robot's map manager has not told its maps in time")};
inline constexpr FaultCode OnlyCurrentMapSent{
    "ros",
    QT_TRANSLATE_NOOP(
        "ros", "The robot sends only the map that it works with. Load this one on the robot to see it.")};
inline constexpr FaultCode OnlyCurrentMapTaken{
    "ros",
    QT_TRANSLATE_NOOP("ros",
                      "The robot sends only the map that it works with, so only that one's picture can be "
                      "saved and compared. Nothing was sent. Load this map on the robot first.")};
/// name
inline constexpr FaultCode PictureChangedMeanwhile{
    "ros", QT_TRANSLATE_NOOP("ros", "the picture of \"%1\" has been changed on the robot meanwhile")};
/// the cell, of 100
inline constexpr FaultCode CellBetweenKinds{
    "ros",
    QT_TRANSLATE_NOOP(
        "ros",
        "Some of its cells are neither free, occupied nor unknown but in between (%1 of 100), and for these "
        "the map manager names no shade. Nothing was sent. Export the map to edit it as files.")};
/// how many cells
inline constexpr FaultCode PictureShownOtherwise{
    "ros",
    QT_TRANSLATE_N_NOOP(
        "ros",
        "The robot has taken the picture, but shows %1 cells otherwise than they were sent. Compare both.")};
inline constexpr FaultCode MessageNotUnderstood{
    "ros", QT_TRANSLATE_NOOP("ros", "Its message is not what is expected there. It was left out.")};
/// name
inline constexpr FaultCode WaypointTurnIsZero{
    "ros", QT_TRANSLATE_NOOP("ros",
                             "Waypoint \"%1\" has no heading (a zero quaternion). It is shown with yaw 0, "
                             "and kept as it is until you turn it.")};
/// name, frame, the map's frame
inline constexpr FaultCode WaypointInOtherFrame{
    "ros", QT_TRANSLATE_NOOP("ros", "Waypoint \"%1\" lies in the frame %2 instead of %3. It was left out.")};
/// name, frame
inline constexpr FaultCode WaypointFrameUnknown{
    "ros", QT_TRANSLATE_NOOP("ros",
                             "Waypoint \"%1\" is told in the frame %2, and no map has come that tells its "
                             "own. It is taken for a place on the map.")};

// What goes over the network. Hosts come with their ports.
/// likewise
inline constexpr FaultCode NoRosbridgeThere{
    "ros",
    QT_TRANSLATE_NOOP(
        "ros",
        "something answers at %1, but not as a rosbridge server: %2. Check the address and the port.")};
/// host
inline constexpr FaultCode NoMapManagerThere{
    "ros", QT_TRANSLATE_NOOP("ros",
                             "a rosbridge server answers at %1, but its robot runs no KABAM map manager "
                             "(/map_manager). Start it, or connect to ros+ws:// for what else there is.")};

}  // namespace mapwright::robot::ros::fault
