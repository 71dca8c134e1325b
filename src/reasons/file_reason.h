// Why a file could not be written or read, as a reason of map.
#pragma once

#include "disk/fault.h"
#include "map/reason.h"

namespace mapwright::reasons {

/// What is wrong with the file, without its name: goes behind "… cannot be read".
map::Reason causeOf(const disk::Fault& fault);
/// "/a.png cannot be written: …", "The standard output cannot be written: …".
map::Reason notWritten(const disk::Fault& fault);

}  // namespace mapwright::reasons
