// Makes the nearly-JSON of some robots readable.
#pragma once

#include <string>
#include <string_view>

namespace mapwright::robot::axbot {

/// The text with NaN, Infinity, -Infinity and numbers that no type holds replaced by null, outside of
/// strings.
std::string repairNumbers(std::string_view text);

}  // namespace mapwright::robot::axbot
