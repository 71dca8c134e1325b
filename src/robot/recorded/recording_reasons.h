// What is wrong with a recording and its messages, and what it says about itself: whether it was finished,
// and when the connection to the robot was lost. Pure. Source: recorder/layout.h (metadata).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fault/fault.h"
#include "recording/ros_cbor.h"
#include "recording/source.h"
#include "robot/bag_library.h"

namespace mapwright::robot::recorded {

/// A problem in a file that is still readable.
Fault reasonOf(const recording::Note& note);
/// Whether data existed and is lost. Otherwise the file is only unfinished or slow to open.
bool isLoss(recording::NoteCode code);
/// Why it cannot be opened.
Fault reasonOf(const recording::Failure& failure);
/// Why messages of `type` cannot be read.
Fault reasonOf(const recording::RosSchemaFault& fault, const std::string& type);
Fault reasonOf(const recording::RosDecodeFault& fault, const std::string& encoding);

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

}  // namespace mapwright::robot::recorded
