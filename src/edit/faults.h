// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::edit::fault {

using namespace mapwright::fault;  // what all rooms share

// Files with waypoints.
inline constexpr FaultCode WaypointListGone{
    "edit", QT_TRANSLATE_NOOP("edit",
                              "The list of waypoints is gone from where it was kept. They are still here: "
                              "saving writes them again.")};

// Drafts.
/// folder
inline constexpr FaultCode DraftFolderNotMade{
    "edit", QT_TRANSLATE_NOOP("edit", "No draft can be kept: the folder %1 cannot be made.")};
/// folder
inline constexpr FaultCode DraftFileNotMade{
    "edit", QT_TRANSLATE_NOOP("edit", "No draft can be kept: no file can be made in %1. Is the disk full?")};
/// path
inline constexpr FaultCode DraftNotRemoved{"edit",
                                           QT_TRANSLATE_NOOP("edit", "The draft %1 cannot be removed.")};
/// path; because: why
inline constexpr FaultCode DraftNotRead{"edit", QT_TRANSLATE_NOOP("edit", "The draft %1 cannot be read")};
/// path
inline constexpr FaultCode DraftBroken{"edit",
                                       QT_TRANSLATE_NOOP("edit", "The draft %1 cannot be understood.")};
/// path, where it is kept
inline constexpr FaultCode DraftSetAside{
    "edit", QT_TRANSLATE_NOOP("edit", "The draft %1 cannot be understood. It is kept as %2.")};

}  // namespace mapwright::edit::fault
