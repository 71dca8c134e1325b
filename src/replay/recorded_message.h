// Which messages of a range somebody recorded.
#pragma once

#include "robot/bag_library.h"

namespace mapwright::replay {

/// Else it was made of others, at a time of no message: it says something of the world, and is in no list.
inline bool isRecorded(const robot::BagMessage& message) { return message.size > 0; }

}  // namespace mapwright::replay
