// The message definitions of the simulated robot's topics, as reported by rosapi.
#pragma once

#include <string_view>

#include "simulator/ros/ros_options.h"
#include "simulator/value.h"

namespace mapwright::simulator::ros {

/// The answer of /rosapi/message_details; the list is empty for an unknown type.
Value messageDetails(std::string_view type, RosDialect dialect);

}  // namespace mapwright::simulator::ros
