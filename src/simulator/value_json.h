// Values as JSON and back.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "simulator/ros/ros_options.h"
#include "simulator/value.h"

namespace mapwright::simulator {

/// What is not finite becomes null.
std::string toJson(const Value& value, RosWriter writer = RosWriter::Plain);

/// Whole numbers and others are told apart (2 and 2.0). nullopt when the text is no JSON.
std::optional<Value> fromJson(std::string_view text);

/// nullopt when it is no base64.
std::optional<std::string> fromBase64(std::string_view text);

}  // namespace mapwright::simulator
