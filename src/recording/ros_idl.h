// The structure of a ROS message from a definition in IDL, as recordings store it ("ros2idl"): the texts of
// .idl files, each after a line of '=' and "IDL: package/msg/Type". Sources: OMG IDL 4.2, as far as ROS 2
// uses it (modules, structs, constants, typedefs, enums, sequences, bounded strings, annotations); MCAP,
// "Well-known schema encodings". Pure; any thread. Untrusted: bounded as parseRosSchema().
#pragma once

#include <string_view>

#include <tl/expected.hpp>

#include "recording/ros_schema.h"

namespace mapwright::recording {

/// `name`: of the message, "nav_msgs/Path" or "nav_msgs/msg/Path".
tl::expected<RosSchema, RosSchemaFault> parseRosIdl(std::string_view name, std::string_view definition);

}  // namespace mapwright::recording
