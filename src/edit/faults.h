// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::edit::fault {

using namespace mapwright::fault;  // what all rooms share

// Files with waypoints.
inline constexpr FaultCode WaypointListGone{
    "edit", QT_TRANSLATE_NOOP("edit",
                              "The saved waypoint draft has disappeared. The waypoints are still open here: "
                              "saving writes them again.")};

// Drafts.
/// folder
inline constexpr FaultCode DraftFolderNotMade{
    "edit", QT_TRANSLATE_NOOP("edit", "Drafts cannot be saved: the folder %1 cannot be created.")};
/// folder
inline constexpr FaultCode DraftFileNotMade{
    "edit",
    QT_TRANSLATE_NOOP("edit", "Drafts cannot be saved: no file can be created in %1. Is the disk full?")};
/// path
inline constexpr FaultCode DraftNotRemoved{"edit",
                                           QT_TRANSLATE_NOOP("edit", "The draft %1 cannot be removed.")};
/// path; because: why
inline constexpr FaultCode DraftNotRead{"edit", QT_TRANSLATE_NOOP("edit", "The draft %1 cannot be read")};
/// path
inline constexpr FaultCode DraftBroken{"edit",
                                       QT_TRANSLATE_NOOP("edit", "The draft %1 is not in a known format.")};
/// path, where it is kept
inline constexpr FaultCode DraftSetAside{
    "edit", QT_TRANSLATE_NOOP("edit", "The draft %1 is not in a known format. It was renamed to %2.")};

}  // namespace mapwright::edit::fault
