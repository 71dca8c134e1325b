// What a recording says about itself: whether it was finished, and when the connection to the robot was lost.
// Pure. Source: recorder/layout.h ("mapwright", "mapwright.end", "mapwright.repaired", "mapwright.link").
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fault/fault.h"
#include "recording/source.h"
#include "robot/bag_library.h"

namespace mapwright::robot::recorded {

/// Its end is missing: the writer was interrupted, or is still writing. True for a file without the end mark
/// of its format, and for one recorded here that does not say that it was finished; not for one that was
/// repaired.
bool isInterrupted(const recording::Source& file);
/// It says that it was finished or repaired: a merged file only has it if all its inputs do.
bool isEndMark(const recording::Metadata& metadata);
/// The metadata for a complete file made from an interrupted one.
recording::Metadata repairMark(const recording::Summary& interrupted);
/// The repair mark of a file; nullopt: there is none.
std::optional<BagRepair> repairOf(const recording::Source& file);
/// The same as a fault, with the time of the last message.
Fault interruptionOf(const recording::Summary& summary);
/// In the order of time.
std::vector<BagAway> awayIn(const recording::Source& file);
Fault reasonOf(const BagAway& away);

/// "2024-06-03 09:00:00.250 UTC".
std::string timeWords(std::int64_t epoch_ns);

}  // namespace mapwright::robot::recorded
