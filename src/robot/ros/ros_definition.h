// What messages are made of, as rosapi tells it (/rosapi/message_details), as the text that stands in
// recordings. Pure. Sources: rosapi_msgs/TypeDef; MCAP, "Well-known schema encodings" (ros1msg, ros2msg).
#pragma once

#include <optional>
#include <string>

#include "net/rosbridge/field.h"

namespace mapwright::robot::ros {

struct RosDefinition {
  bool ros2 = false;
  std::string text;  // the fields of the type, then those of all types in it, behind lines of '='
};

/// `typedefs` as it was answered; its first is the type that was asked for. nullopt: it is none, or tells of
/// types that are not in it. Constants are left out: rosapi does not tell their types.
std::optional<RosDefinition> definitionIn(const net::rosbridge::Field& typedefs);

/// Of a type whose only field is `name`, of the type `type` that `inner` is about.
RosDefinition definitionAround(const RosDefinition& inner, const std::string& type, const std::string& name);

}  // namespace mapwright::robot::ros
