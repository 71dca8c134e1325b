// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::agreement::fault {

using namespace mapwright::fault;  // what all rooms share

/// the most tiles, the edge of one in metres
inline constexpr FaultCode TooLarge{
    "agreement",
    QT_TRANSLATE_NOOP("agreement",
                      "The submaps cover more than the %1 squares of %2 m that can be looked at. "
                      "Larger cells need fewer squares.")};

}  // namespace mapwright::agreement::fault
