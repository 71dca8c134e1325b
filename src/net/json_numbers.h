// Makes the numbers of nearly-JSON readable. Pure functions.
#pragma once

#include <string>
#include <string_view>

namespace mapwright::net {

/// The text with NaN, Infinity, -Infinity and numbers that no type holds replaced by null, outside of
/// strings.
std::string repairNumbers(std::string_view text);

/// The text with every whole number of more than 15 digits made a string, so that no digit is lost on its way
/// through a double.
std::string quoteLongNumbers(std::string_view text);

}  // namespace mapwright::net
