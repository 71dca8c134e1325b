// What is found to be wrong here, with its words. Arguments are named in their order (%1 is the first).
#pragma once

#include "fault/fault.h"

namespace mapwright::jobs::fault {

using namespace mapwright::fault;  // what all rooms share

}  // namespace mapwright::jobs::fault
