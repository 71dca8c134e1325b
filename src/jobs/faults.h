// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::jobs::fault {

using namespace mapwright::fault;  // what all rooms share

// Making and writing pictures.
/// path, the library's words
inline constexpr FaultCode PictureNotEncoded{
    "jobs", QT_TRANSLATE_NOOP("jobs", "The picture for %1 cannot be encoded: %2.")};

// Changing overlays.
/// because: what is wrong with them
inline constexpr FaultCode OverlaysNotRead{
    "jobs", QT_TRANSLATE_NOOP("jobs", "The overlays that the robot holds cannot be read")};
/// the name of the map
inline constexpr FaultCode AnotherMap{
    "jobs",
    QT_TRANSLATE_NOOP(
        "jobs", "This version is of another map than \"%1\". Pass --map to use it there all the same.")};

// Downloading maps.
/// the folder
inline constexpr FaultCode FolderInUse{"jobs",
                                       QT_TRANSLATE_NOOP("jobs", "Another download into %1 is under way.")};

// Looking for robots.
/// seconds, as text
inline constexpr FaultCode NothingWithin{"jobs", QT_TRANSLATE_NOOP("jobs", "no answer within %1 s")};

}  // namespace mapwright::jobs::fault
