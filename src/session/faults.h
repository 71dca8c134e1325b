// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::session::fault {

using namespace mapwright::fault;  // what all rooms share

// The pictures of submaps.
/// because: what is wrong with each
inline constexpr FaultCode Slices{"session", "%1", FaultCode::Causes::Alone};
/// version; because: why
inline constexpr FaultCode VersionNotHad{"session", QT_TRANSLATE_NOOP("session", "Version %1"),
                                         FaultCode::Causes::Capital};

}  // namespace mapwright::session::fault
