// Definitions of common message types of ROS 2, for recordings that hold none (rosbag2 before Iron). Written
// from the documentation of the packages; only fields, no constants. Pure; any thread.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mapwright::recording {

/// In the form "ros2msg", with those of all types in it. Of types that changed, each form, the newest first.
/// Empty: the type is not known here. `type`: "nav_msgs/msg/Path".
std::vector<std::string> knownDefinitions(std::string_view type);

/// Whether a CDR message ends where this definition of it ends.
bool fitsDefinition(const std::string& type, const std::string& definition,
                    std::span<const std::uint8_t> message);

}  // namespace mapwright::recording
