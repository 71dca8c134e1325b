// The message types of the simulated robot: how strictly it checks them (docs/protocols/rosbridge.md,
// "Calls"), and how rosapi tells of them.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "simulator/value.h"

namespace mapwright::simulator::ros {

/// A value, or the server's sentence why there is none.
using Answer = tl::expected<Value, std::string>;

/// Immutable, safe from any thread. Types are named without the middle part: "nav_msgs/Path".
class MessageTypes {
 public:
  explicit MessageTypes(RosDialect dialect);

  /// Whether messages of this type are checked.
  bool knows(std::string_view type) const { return checkedFields(type) != nullptr; }
  /// `given` as a complete message of `type`: omitted members are zero, and numbers have their field's type.
  Answer complete(std::string_view type, const Value& given) const;
  /// The same from the values of its first fields, in order.
  Answer fromList(std::string_view type, const Value::List& given) const;
  /// The answer of /rosapi/message_details; the list is empty for an unknown type.
  Value details(std::string_view type) const;

 private:
  struct Field {
    std::string type, name;
    int length = kSingle;  // of a list; 0: any
    bool isList() const { return length != kSingle; }
  };
  static constexpr int kSingle = -1;
  struct Type {
    unsigned use = 0;
    std::vector<Field> fields;
  };

  const std::vector<Field>* checkedFields(std::string_view type) const;
  Answer list(std::string_view type, const Field& field, const Value* given) const;
  Answer single(std::string_view type, const Field& field, const Value* given) const;
  void listTypes(Value::List& all, std::set<std::string>& seen, const std::string& type) const;

  const RosDialect dialect_;
  std::map<std::string, Type, std::less<>> types_;
};

struct Service {
  std::string name;       // "/map_manager/load_map"
  std::string_view type;  // "kabam_msgs/LoadMap"
  /// What it answers to a complete request; it changes nothing if it does not `keep` what it did.
  std::function<Answer(const Value& request, bool keep)> answer;
  bool changes = false;
};

/// The type as this dialect names it: "nav_msgs/msg/Path" with `kind` "msg" on ROS 2.
std::string typeName(std::string_view plain, std::string_view kind, RosDialect dialect);

}  // namespace mapwright::simulator::ros
