// Text of others (names, messages, paths) made harmless before it leaves the program: for terminals, reports,
// log lines, the clipboard and labels. Pure functions on UTF-8; words/qt_plain.h has them for QString.
#pragma once

#include <string>
#include <string_view>

namespace mapwright::words {

/// One line without anything that is obeyed instead of shown: control characters (C0, DEL, C1), tabs and line
/// ends become blanks, overrides and isolates of the writing direction go, what is no UTF-8 becomes U+FFFD.
std::string plainLine(std::string_view utf8);
/// The same, but line feeds and tabs stay.
std::string plainText(std::string_view utf8);
/// JSON, complete and valid, in which such characters are escaped (\u007f) instead: nothing of it is lost.
std::string escapedJson(std::string_view json);

}  // namespace mapwright::words
