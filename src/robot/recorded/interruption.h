// What a recording tells of how it was made: whether it was finished, and where the link to the robot was
// away meanwhile. Pure. Source: recorder/layout.h ("mapwright", "mapwright.end", "mapwright.repaired",
// "mapwright.link").
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fault/fault.h"
#include "recording/source.h"
#include "robot/bag_library.h"

namespace mapwright::robot::recorded {

/// Its end is missing: whoever wrote it was interrupted, or still writes. So it is with a file without the
/// end mark of its format, and with one that was recorded here and does not say that it was finished; not
/// with one that was repaired since.
bool isInterrupted(const recording::Source& file);
/// Says that it was finished, or repaired: the whole of several has it only where each of them has.
bool isEndMark(const recording::Metadata& metadata);
/// What is to be written into a whole file made of what was interrupted so.
recording::Metadata repairMark(const recording::Summary& interrupted);
/// Such a file; nullopt: it is none.
std::optional<BagRepair> repairOf(const recording::Source& file);
/// The same in words, with the time of the last message.
Fault interruptionOf(const recording::Summary& summary);
/// In the order of time.
std::vector<BagAway> awayIn(const recording::Source& file);
Fault reasonOf(const BagAway& away);

/// "2024-06-03 09:00:00.250 UTC".
std::string timeWords(std::int64_t epoch_ns);

}  // namespace mapwright::robot::recorded
