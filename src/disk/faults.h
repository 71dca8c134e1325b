// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::disk::fault {

using namespace mapwright::fault;  // what all rooms share

// Files of any kind.
/// path; because: why
inline constexpr FaultCode FileNotWritten{"disk", QT_TRANSLATE_NOOP("disk", "%1 cannot be written")};
inline constexpr FaultCode IsAFolder{"disk", QT_TRANSLATE_NOOP("disk", "it is a directory")};
inline constexpr FaultCode NotARegularFile{"disk", QT_TRANSLATE_NOOP("disk", "it is not a regular file")};
inline constexpr FaultCode GitLfsPointer{
    "disk",
    QT_TRANSLATE_NOOP("disk", "it is a pointer of Git LFS, not the file itself (git lfs pull fetches it)")};
/// path
inline constexpr FaultCode NameTaken{
    "disk", QT_TRANSLATE_NOOP("disk", "a file of that name is there already; the result is in %1")};
/// folder, the system's words
inline constexpr FaultCode NoFileInFolder{"disk",
                                          QT_TRANSLATE_NOOP("disk", "no file can be created in %1 (%2)")};

}  // namespace mapwright::disk::fault
