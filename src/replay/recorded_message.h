// Which messages of a range were recorded.
#pragma once

#include "robot/bag_library.h"

namespace mapwright::replay {

/// The others were derived at a time without a message: they affect the world but are not listed.
inline bool isRecorded(const robot::BagMessage& message) { return message.size > 0; }

}  // namespace mapwright::replay
