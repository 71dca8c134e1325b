// Long texts in pieces, as rosbridge servers cut them.
#pragma once

#include <string>
#include <vector>

#include "simulator/ros/ros_options.h"
#include "simulator/ros/value.h"

namespace mapwright::simulator::ros {

/// The text itself when it has no more than `size` characters or `size` is 0; else {"op":"fragment"} messages
/// of `size` characters each. Their id is that of the message, 0 for those without one; their total is a
/// fraction.
std::vector<std::string> fragmentsOf(std::string text, std::size_t size, const Value& id, RosWriter writer);

}  // namespace mapwright::simulator::ros
