// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::edit::fault {

using namespace mapwright::fault;  // what all rooms share

// Drafts.
/// folder
inline constexpr FaultCode DraftFolderNotMade{
    "edit", QT_TRANSLATE_NOOP("edit", "Drafts cannot be saved: the folder %1 cannot be created.")};

}  // namespace mapwright::edit::fault
