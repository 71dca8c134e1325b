// Turns the numbers of almost valid JSON into valid ones. Pure functions.
#pragma once

#include <string>
#include <string_view>

namespace mapwright::net {

/// The text with NaN, Infinity, -Infinity and numbers out of range replaced by null, outside of strings.
std::string repairNumbers(std::string_view text);

/// The text with every whole number of more than 15 digits turned into a string, so that no digit is lost in
/// a double.
std::string quoteLongNumbers(std::string_view text);

}  // namespace mapwright::net
