// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::session::fault {

using namespace mapwright::fault;  // what all rooms share

// The list of submaps.
inline constexpr FaultCode OlderVersionListed{
    "session", QT_TRANSLATE_NOOP("session", "The robot lists an older version than the one shown.")};

// The pictures of submaps.
/// because: what is wrong with each
inline constexpr FaultCode Slices{"session", "%1", FaultCode::Causes::Alone};
/// version; because: why
inline constexpr FaultCode VersionNotHad{"session", QT_TRANSLATE_NOOP("session", "Version %1"),
                                         FaultCode::Causes::Capital};
/// because: why
inline constexpr FaultCode NotHad{"session", QT_TRANSLATE_NOOP("session", "It cannot be loaded")};
/// version listed, version that came
inline constexpr FaultCode OlderVersionCame{
    "session",
    QT_TRANSLATE_NOOP("session", "Version %1 is listed, but the robot sent version %2. It is shown.")};
/// why no file can be written
inline constexpr FaultCode MemoryUsedUp{
    "session", QT_TRANSLATE_NOOP("session",
                                 "It is used up, and no file can be written for the other submaps: %1. They "
                                 "stay in memory; free some disk space.")};

// Whole maps.
/// width and height as said, width and height of the picture
inline constexpr FaultCode SizesDiffer{
    "session",
    QT_TRANSLATE_NOOP(
        "session",
        "Its metadata says %1 x %2 cells, but its picture has %3 x %4. The size of the picture is used.")};
/// file name; because: what is wrong with it
inline constexpr FaultCode PictureOfIt{"session", QT_TRANSLATE_NOOP("session", "Picture %1"),
                                       FaultCode::Causes::Capital};
inline constexpr FaultCode TurnNoNumber{
    "session", QT_TRANSLATE_NOOP(
                   "session", "The rotation of its origin is not a number. It is shown without rotation.")};
inline constexpr FaultCode CacheCopyDamaged{
    "session",
    QT_TRANSLATE_NOOP("session", "The cached copy was damaged. The map was read again from its picture.")};
/// its key
inline constexpr FaultCode AnotherMapCame{
    "session", QT_TRANSLATE_NOOP("session", "The robot sent another map, %1. It is not shown.")};

// Live messages.
inline constexpr FaultCode CameWithoutPicture{"session",
                                              QT_TRANSLATE_NOOP("session", "It arrived without a picture.")};

}  // namespace mapwright::session::fault
