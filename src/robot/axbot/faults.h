// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::robot::axbot::fault {

using namespace mapwright::fault;  // what all rooms share

// Who answers at an address.
/// because: how it answers
inline constexpr FaultCode NoAutoxingRobotAnswers{
    "axbot", QT_TRANSLATE_NOOP("axbot", "a web server answers there, but not as an Autoxing robot does: %1")};
inline constexpr FaultCode AnotherServerAnswers{
    "axbot", QT_TRANSLATE_NOOP("axbot", "a web server answers there, but it is no Autoxing robot")};

// The list of submaps.
/// position in the list
inline constexpr FaultCode RowWithoutNumbers{
    "axbot",
    QT_TRANSLATE_NOOP("axbot", "Row %1 has no valid trajectory_id or submap_index and was left out.")};
inline constexpr FaultCode NoListInIt{
    "axbot", QT_TRANSLATE_NOOP("axbot", "It contains no list of submaps. The previous list stays.")};
/// how many
inline constexpr FaultCode NoRowReadable{
    "axbot",
    QT_TRANSLATE_N_NOOP("axbot",
                        "None of its %1 rows has a valid trajectory_id and submap_index. The previous "
                        "list stays.")};
inline constexpr FaultCode ListWithoutUuid{
    "axbot", QT_TRANSLATE_NOOP("axbot",
                               "It lists submaps, but not the uuid of their SLAM session, so none can be "
                               "loaded. The previous list stays.")};
/// topic
inline constexpr FaultCode NoListYet{
    "axbot", QT_TRANSLATE_NOOP("axbot",
                               "The robot has not sent a list yet. It may have no SLAM session, or its "
                               "firmware may not have the topic %1. Still listening.")};

// The pictures of submaps.
inline constexpr FaultCode EmptyAnswer{"axbot",
                                       QT_TRANSLATE_NOOP("axbot", "The robot sent an empty answer.")};
/// bytes
inline constexpr FaultCode AnswerIsNoSubmap{
    "axbot", QT_TRANSLATE_N_NOOP("axbot", "The robot's answer (%1 bytes) is cut off or is not a submap.")};
/// its code; because: its words
inline constexpr FaultCode RobotAnswered{"axbot", QT_TRANSLATE_NOOP("axbot", "The robot answered %1")};

// Whole maps.
/// its name; because: why
inline constexpr FaultCode FileNotHad{"axbot", QT_TRANSLATE_NOOP("axbot", "Shown without %1")};
inline constexpr FaultCode AnswerIsNoList{"axbot", QT_TRANSLATE_NOOP("axbot", "its answer is not a list")};
inline constexpr FaultCode AnswerIsNoPicture{
    "axbot", QT_TRANSLATE_NOOP("axbot", "The robot's answer is not a map picture, or is cut off.")};
inline constexpr FaultCode NoPictureSent{"axbot", QT_TRANSLATE_NOOP("axbot", "The robot sent no picture.")};

// Live messages.
/// bytes
inline constexpr FaultCode MessageNotJson{
    "axbot", QT_TRANSLATE_N_NOOP("axbot", "A message of %1 bytes is not a JSON object. It was left out.")};
/// bytes
inline constexpr FaultCode BinaryTooShort{
    "axbot",
    QT_TRANSLATE_N_NOOP("axbot", "A binary message of %1 bytes is too short to be read. It was left out.")};
inline constexpr FaultCode NotUnpacked{
    "axbot",
    QT_TRANSLATE_NOOP("axbot", "A compressed message could not be unpacked. The previous data stays.")};
inline constexpr FaultCode BinaryWithoutPoints{
    "axbot", QT_TRANSLATE_NOOP("axbot", "A binary message contains no readable points.")};
inline constexpr FaultCode BinaryWithoutList{
    "axbot", QT_TRANSLATE_NOOP("axbot", "A binary message could not be read. The previous list stays.")};
inline constexpr FaultCode PoseWithoutNumbers{
    "axbot", QT_TRANSLATE_NOOP("axbot", "The robot's pose contains no valid numbers.")};
/// member
inline constexpr FaultCode MemberIsNoList{"axbot",
                                          QT_TRANSLATE_NOOP("axbot", "Its \"%1\" member is not a list.")};
/// type
inline constexpr FaultCode GeometryUnknown{"axbot",
                                           QT_TRANSLATE_NOOP("axbot", "Its geometry \"%1\" is not known.")};
inline constexpr FaultCode GeometryUnreadable{
    "axbot", QT_TRANSLATE_NOOP("axbot", "Its coordinates are missing, too few, or not numbers.")};
/// how many
inline constexpr FaultCode FeaturesUnreadable{
    "axbot", QT_TRANSLATE_N_NOOP("axbot", "%1 features of its overlays cannot be read.")};
inline constexpr FaultCode PictureInMessageNotBase64{
    "axbot", QT_TRANSLATE_NOOP("axbot", "The picture in the message is not valid base64, or too large.")};
inline constexpr FaultCode NoPictureNorAddress{
    "axbot", QT_TRANSLATE_NOOP("axbot", "It contains neither a picture nor the address of one.")};
inline constexpr FaultCode PictureAddressInvalid{
    "axbot", QT_TRANSLATE_NOOP("axbot", "The address of its picture is not valid.")};
/// path; because: why
inline constexpr FaultCode PictureNotHad{"axbot",
                                         QT_TRANSLATE_NOOP("axbot", "Its picture %1 cannot be loaded")};
inline constexpr FaultCode AnswerIsEmpty{"axbot", QT_TRANSLATE_NOOP("axbot", "the answer is empty")};
inline constexpr FaultCode PointsNotBase64{
    "axbot", QT_TRANSLATE_NOOP("axbot", "Its points are not valid base64, or too many.")};
inline constexpr FaultCode NoReadablePoints{"axbot",
                                            QT_TRANSLATE_NOOP("axbot", "It contains no readable points.")};
inline constexpr FaultCode PointsWithoutScale{
    "axbot", QT_TRANSLATE_NOOP("axbot", "Its points have no valid scale or centre.")};

// The robot itself.
/// because: why
inline constexpr FaultCode AnswersNotKept{
    "axbot", QT_TRANSLATE_NOOP("axbot", "The robot's answers cannot be saved to disk")};
/// because: why
inline constexpr FaultCode DoesNotSayWhatItIs{"axbot",
                                              QT_TRANSLATE_NOOP("axbot", "It does not report what it is")};

// Bags.
inline constexpr FaultCode BagWithoutTimes{
    "axbot", QT_TRANSLATE_NOOP("axbot", "the answer does not contain its start and end time")};
inline constexpr FaultCode BagWithoutMessages{
    "axbot", QT_TRANSLATE_NOOP("axbot", "the answer contains no list of messages")};
/// what is wrong with the range that was asked for
inline constexpr FaultCode BagNotAsked{"axbot", QT_TRANSLATE_NOOP("axbot", "%1 is not a time range")};
/// path, the system's words
inline constexpr FaultCode BagFileNotWritten{"axbot", QT_TRANSLATE_NOOP("axbot", "%1 cannot be written: %2")};
/// bytes that came, bytes as announced
inline constexpr FaultCode BagFileOfOtherSize{
    "axbot", QT_TRANSLATE_NOOP("axbot", "%1 bytes arrived, but the robot says that it has %2")};

// What goes over the network. Hosts come with their ports.
/// host; because: how it answers
inline constexpr FaultCode NoAutoxingRobotThere{
    "axbot",
    QT_TRANSLATE_NOOP(
        "axbot", "there is a server at %1, but not an Autoxing robot: %2. Check the address and the port.")};

// What it sees around it.
inline constexpr FaultCode SeesNoCharger{"axbot",
                                         QT_TRANSLATE_NOOP("axbot", "The robot sees no charger here.")};
inline constexpr FaultCode SeesNoRack{"axbot", QT_TRANSLATE_NOOP("axbot", "The robot sees no rack here.")};
inline constexpr FaultCode SeesNoPallet{"axbot",
                                        QT_TRANSLATE_NOOP("axbot", "The robot sees no pallet here.")};
inline constexpr FaultCode SeesNoTrailer{"axbot",
                                         QT_TRANSLATE_NOOP("axbot", "The robot sees no trailer here.")};
inline constexpr FaultCode SightingUnreadable{
    "axbot", QT_TRANSLATE_NOOP("axbot", "The robot's answer contains no pose that can be read.")};

// Where the robot is.
inline constexpr FaultCode PoseNotTold{
    "axbot", QT_TRANSLATE_NOOP("axbot", "the robot accepted the pose, but does not say where it is")};
inline constexpr FaultCode PoseAsBefore{
    "axbot", QT_TRANSLATE_NOOP(
                 "axbot", "The robot accepted the pose, but says that it is still where it was before.")};
inline constexpr FaultCode ResultNotTold{
    "axbot", QT_TRANSLATE_NOOP("axbot", "the robot accepted it, but does not say what came of it")};

// Whole maps on their way.
inline constexpr FaultCode ChangedMeanwhile{
    "axbot",
    QT_TRANSLATE_NOOP("axbot", "it was changed on the robot in the meantime; start the download again")};
/// id, name
inline constexpr FaultCode UidTaken{"axbot",
                                    QT_TRANSLATE_NOOP("axbot", "the robot already has this map: %2 (id %1)")};

// Changing maps.
inline constexpr FaultCode RecordingNotListed{
    "axbot", QT_TRANSLATE_NOOP("axbot", "The robot accepted the recording, but does not list it.")};
inline constexpr FaultCode StillThere{
    "axbot", QT_TRANSLATE_NOOP("axbot", "The robot accepted the deletion, but still has it.")};
inline constexpr FaultCode MappingKept{
    "axbot", QT_TRANSLATE_NOOP(
                 "axbot", "The robot ended mapping, but kept what was mapped: it lists it as finished.")};
inline constexpr FaultCode MappingDropped{
    "axbot", QT_TRANSLATE_NOOP("axbot", "The robot ended mapping, but lists it as cancelled.")};
inline constexpr FaultCode NothingMapped{
    "axbot", QT_TRANSLATE_NOOP("axbot", "There is no finished mapping that could be saved.")};

}  // namespace mapwright::robot::axbot::fault
