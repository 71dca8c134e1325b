// Words for what a robot says of its state.
#pragma once

#include <string>

#include <QString>

namespace mapwright::sentences {

/// "excellent", "good", …; "quality 5" for an unknown number.
QString qualityWord(int quality);
/// "driving to its target" for "moving"; what is not known in quotation marks, as one line of plain text.
QString plannerWord(const std::string& move_state);
/// What robots commonly say of themselves ("charging", "moving") in the language spoken; others as they are,
/// as one line of plain text.
QString stateWord(const std::string& state);
/// "open", "closed", "opening", "closing", "unknown"; others as they are, as one line of plain text.
QString doorWord(const std::string& state);
/// "no way was found for too long (PlanningTimeout)" for the maker's code or its name, with or without
/// further words behind it; others as they are, as one line of plain text.
QString failureWords(const std::string& reason);

}  // namespace mapwright::sentences
