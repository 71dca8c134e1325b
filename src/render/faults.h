// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::render::fault {

using namespace mapwright::fault;  // what all rooms share

// Making and writing pictures.
inline constexpr FaultCode ResolutionNotAboveZero{
    "render", QT_TRANSLATE_NOOP("render", "The resolution must be greater than 0.")};
inline constexpr FaultCode NoSubmapToExport{
    "render", QT_TRANSLATE_NOOP("render", "There are no submaps to export yet.")};
inline constexpr FaultCode ComposedTooLarge{
    "render",
    QT_TRANSLATE_NOOP("render",
                      "The map is too large for one picture at this resolution. Choose a coarser one.")};

}  // namespace mapwright::render::fault
