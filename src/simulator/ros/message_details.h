// What the messages of the simulated robot's topics are made of, as rosapi tells it.
#pragma once

#include <string_view>

#include "simulator/ros/ros_options.h"
#include "simulator/value.h"

namespace mapwright::simulator::ros {

/// The answer of /rosapi/message_details; without a type that nobody here knows its list is empty.
Value messageDetails(std::string_view type, RosDialect dialect);

}  // namespace mapwright::simulator::ros
