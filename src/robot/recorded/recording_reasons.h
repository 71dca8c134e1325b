// What is wrong with a recording and with messages in it, in the words of the map (sentences/). Pure.
#pragma once

#include <string>

#include "fault/fault.h"
#include "recording/note.h"
#include "recording/ros_decode.h"
#include "recording/ros_schema.h"

namespace mapwright::robot::recorded {

/// What was found in a file that is read all the same.
Fault reasonOf(const recording::Note& note);
/// Whether what is missing was there: messages are lost. Else the file is only unfinished or slow to open.
bool isLoss(recording::NoteCode code);
/// Why it cannot be opened.
Fault reasonOf(const recording::Failure& failure);
/// Why messages of `type` cannot be read.
Fault reasonOf(const recording::RosSchemaFault& fault, const std::string& type);
Fault reasonOf(const recording::RosDecodeFault& fault, const std::string& encoding);

}  // namespace mapwright::robot::recorded
