// Writing JSON piece by piece.
#pragma once

#include <string>
#include <string_view>

namespace mapwright::simulator {

/// Appends `text` (UTF-8) in quotes, escaped.
void appendJsonText(std::string& out, std::string_view text);
/// Appends the shortest text that reads back as `number`; null when it is not finite.
void appendJsonNumber(std::string& out, double number);
/// Appends `number` with `digits` decimals; null if it is not finite.
void appendJsonFixed(std::string& out, double number, int digits);

}  // namespace mapwright::simulator
