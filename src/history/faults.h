// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::history::fault {

using namespace mapwright::fault;  // what all rooms share

/// the file; because: SQLite's words
inline constexpr FaultCode StoreNotUsable{
    "history", QT_TRANSLATE_NOOP("history", "The versions kept in %1 cannot be read or written")};
/// the number
inline constexpr FaultCode NoSuchVersion{"history",
                                         QT_TRANSLATE_NOOP("history", "There is no version %1 here.")};

/// the number
inline constexpr FaultCode VersionDamaged{
    "history", QT_TRANSLATE_NOOP("history", "Version %1 is damaged on the disk. Nothing is done with it.")};

}  // namespace mapwright::history::fault
