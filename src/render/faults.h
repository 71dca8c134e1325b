// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::render::fault {

using namespace mapwright::fault;  // what all rooms share

// Making and writing pictures.
inline constexpr FaultCode NoSubmapToExport{
    "render", QT_TRANSLATE_NOOP("render", "There are no submaps to export yet.")};

}  // namespace mapwright::render::fault
