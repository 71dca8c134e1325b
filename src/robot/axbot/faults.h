// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::robot::axbot::fault {

using namespace mapwright::fault;  // what all rooms share

// The list of submaps.
/// position in the list
inline constexpr FaultCode RowWithoutNumbers{
    "axbot",
    QT_TRANSLATE_NOOP("axbot", "Row %1 has no valid trajectory_id or submap_index and was left out.")};
/// how many
inline constexpr FaultCode NoRowReadable{
    "axbot",
    QT_TRANSLATE_N_NOOP("axbot",
                        "None of its %1 rows has a valid trajectory_id and submap_index. The previous "
                        "list stays.")};

// The pictures of submaps.
/// bytes
inline constexpr FaultCode AnswerIsNoSubmap{
    "axbot", QT_TRANSLATE_N_NOOP("axbot", "The robot's answer (%1 bytes) is cut off or is not a submap.")};
/// its code; because: its words
inline constexpr FaultCode RobotAnswered{"axbot", QT_TRANSLATE_NOOP("axbot", "The robot answered %1")};

// Whole maps.
/// its name; because: why
inline constexpr FaultCode FileNotHad{"axbot", QT_TRANSLATE_NOOP("axbot", "Shown without %1")};
inline constexpr FaultCode AnswerIsNoList{"axbot", QT_TRANSLATE_NOOP("axbot", "its answer is not a list")};

// Live messages.
/// bytes
inline constexpr FaultCode MessageNotJson{
    "axbot", QT_TRANSLATE_N_NOOP("axbot", "A message of %1 bytes is not a JSON object. It was left out.")};
/// bytes
inline constexpr FaultCode BinaryTooShort{
    "axbot",
    QT_TRANSLATE_N_NOOP("axbot", "A binary message of %1 bytes is too short to be read. It was left out.")};
/// member
inline constexpr FaultCode MemberIsNoList{"axbot",
                                          QT_TRANSLATE_NOOP("axbot", "Its \"%1\" member is not a list.")};
inline constexpr FaultCode GeometryUnreadable{
    "axbot", QT_TRANSLATE_NOOP("axbot", "Its coordinates are missing, too few, or not numbers.")};
inline constexpr FaultCode PictureAddressInvalid{
    "axbot", QT_TRANSLATE_NOOP("axbot", "The address of its picture is not valid.")};
/// path; because: why
inline constexpr FaultCode PictureNotHad{"axbot",
                                         QT_TRANSLATE_NOOP("axbot", "Its picture %1 cannot be loaded")};
inline constexpr FaultCode AnswerIsEmpty{"axbot", QT_TRANSLATE_NOOP("axbot", "the answer is empty")};

// Bags.
/// what is wrong with the range that was asked for
inline constexpr FaultCode BagNotAsked{"axbot", QT_TRANSLATE_NOOP("axbot", "%1 is not a time range")};
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
inline constexpr FaultCode SightingUnreadable{
    "axbot", QT_TRANSLATE_NOOP("axbot", "The robot's answer contains no pose that can be read.")};

// Whole maps on their way.
inline constexpr FaultCode ChangedMeanwhile{
    "axbot",
    QT_TRANSLATE_NOOP("axbot", "it was changed on the robot in the meantime; start the download again")};

// Changing maps.
inline constexpr FaultCode StillThere{
    "axbot", QT_TRANSLATE_NOOP("axbot", "The robot accepted the deletion, but still has it.")};

}  // namespace mapwright::robot::axbot::fault
