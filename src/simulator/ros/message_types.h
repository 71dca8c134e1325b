// The message types of the simulated robot, and how strictly it checks them (docs/protocols/rosbridge.md,
// "Calls").
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "simulator/ros/ros_options.h"
#include "simulator/value.h"

namespace mapwright::simulator::ros {

/// Immutable, safe from any thread. Types are named without the middle part: "nav_msgs/Path".
class MessageTypes {
 public:
  explicit MessageTypes(RosDialect dialect);

  bool knows(std::string_view type) const { return types_.find(type) != types_.end(); }
  /// `given` as a complete message of `type`: omitted members are zero, and numbers have their field's type.
  /// The error is the server's sentence.
  tl::expected<Value, std::string> complete(std::string_view type, const Value& given) const;
  /// The same from the values of its first fields, in order.
  tl::expected<Value, std::string> fromList(std::string_view type, const Value::List& given) const;

 private:
  struct Field {
    std::string type, name;
    bool is_list = false;
  };
  using Read = tl::expected<Value, std::string>;

  Read field(std::string_view type, const Field& field, const Value* given) const;
  Read list(std::string_view type, const Field& field, const Value* given) const;
  Read single(std::string_view type, const Field& field, const Value* given) const;

  std::map<std::string, std::vector<Field>, std::less<>> types_;
};

/// The type as this dialect names it: "nav_msgs/msg/Path" with `kind` "msg" on ROS 2.
std::string typeName(std::string_view plain, std::string_view kind, RosDialect dialect);

/// Whether the type `named` by a client means `plain`. ROS 1 does not accept the middle part.
bool sameType(std::string_view named, std::string_view plain, std::string_view kind, RosDialect dialect);

}  // namespace mapwright::simulator::ros
