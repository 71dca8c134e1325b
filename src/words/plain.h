// Makes untrusted text (names, messages, paths) harmless before it leaves the program: for terminals,
// reports, log lines, the clipboard and labels. Pure functions on UTF-8; words/qt_plain.h has them for
// QString.
#pragma once

#include <string>
#include <string_view>

namespace mapwright::words {

/// One line without characters that have an effect instead of a shape: control characters (C0, DEL, C1), tabs
/// and line breaks become blanks, bidirectional overrides and isolates are removed, invalid UTF-8 becomes
/// U+FFFD.
std::string plainLine(std::string_view utf8);
/// The same, but line feeds and tabs stay.
std::string plainText(std::string_view utf8);
/// JSON in which such characters are escaped (\u007f) instead; complete, valid and lossless.
std::string escapedJson(std::string_view json);

}  // namespace mapwright::words
