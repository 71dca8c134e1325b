// Message definitions from rosapi (/rosapi/message_details), in the text form used in recordings. Pure.
// Sources: rosapi_msgs/TypeDef; MCAP, "Well-known schema encodings" (ros1msg, ros2msg).
#pragma once

#include <optional>
#include <string>

#include "net/rosbridge/field.h"

namespace mapwright::robot::ros {

struct RosDefinition {
  bool ros2 = false;
  std::string
      text;  // the fields of the type, followed by those of all types in it, separated by lines of '='
};

/// `typedefs` as received; the first is the requested type. nullopt: invalid, or it refers to missing types.
/// Constants are left out: rosapi does not give their types.
std::optional<RosDefinition> definitionIn(const net::rosbridge::Field& typedefs);

/// For a type whose only field is `name`, of the type `type` described by `inner`.
RosDefinition definitionAround(const RosDefinition& inner, const std::string& type, const std::string& name);

}  // namespace mapwright::robot::ros
