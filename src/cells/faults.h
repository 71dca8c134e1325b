// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::cells::fault {

using namespace mapwright::fault;  // what all rooms share

// The cells of a slice.
/// bytes, as many as one byte a cell makes, as two make
inline constexpr FaultCode BytesUnexpected{
    "cells", QT_TRANSLATE_N_NOOP("cells", "%1 bytes where %2 (or %3) were expected")};
inline constexpr FaultCode GzipDamaged{"cells",
                                       QT_TRANSLATE_NOOP("cells", "the gzip data is damaged or cut off")};

}  // namespace mapwright::cells::fault
