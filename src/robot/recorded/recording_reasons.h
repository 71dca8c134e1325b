// Problems of a recording and its messages as faults of the map. Pure.
#pragma once

#include <string>

#include "fault/fault.h"
#include "recording/note.h"
#include "recording/ros_decode.h"
#include "recording/ros_schema.h"

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

}  // namespace mapwright::robot::recorded
