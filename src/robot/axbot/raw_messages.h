// Formats messages for the raw-message inspector. Source: docs/protocols/autoxing.md, "Live topics".
#pragma once

#include <string>
#include <string_view>

#include "robot/robot.h"

namespace mapwright::robot::axbot {

/// A text frame as received, truncated at kMaxRawText.
RawMessage rawText(const std::string& topic, std::string_view utf8);
/// A binary frame as readable JSON if its message is known and not too long, otherwise as a hex dump.
RawMessage rawBinary(std::string_view bytes);

}  // namespace mapwright::robot::axbot
