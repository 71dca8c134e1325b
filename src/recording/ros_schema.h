// The structure of a ROS message, parsed from its definition as stored in recordings: the text of the .msg
// file, followed by those of all types in it, each after a line of '=' and "MSG: package/Type". Sources: ROS
// wiki, "msg"; ROS 2, "About ROS 2 interfaces" (bounds, defaults, wide strings); MCAP, "Well-known schema
// encodings" ("ros1msg", "ros2msg").
// Pure; any thread. Definitions are untrusted: they are bounded, and recursive ones are rejected.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace mapwright::recording {

enum class RosKind : std::uint8_t {
  Flag,
  Int8,
  Uint8,
  Int16,
  Uint16,
  Int32,
  Uint32,
  Int64,
  Uint64,
  Float32,
  Float64,
  Text,
  WideText,  // of ROS 2
  Time,      // of ROS 1: seconds and nanoseconds, unsigned
  Duration,  // of ROS 1: signed
  Nested,    // RosField::type
};
/// Calls `visit` with a zero of the number type (or bool) of a kind; false: it is another kind.
template <typename Visit>
bool visitNumber(RosKind kind, Visit&& visit) {
  switch (kind) {
    case RosKind::Flag:
      return visit(false), true;
    case RosKind::Int8:
      return visit(std::int8_t()), true;
    case RosKind::Uint8:
      return visit(std::uint8_t()), true;
    case RosKind::Int16:
      return visit(std::int16_t()), true;
    case RosKind::Uint16:
      return visit(std::uint16_t()), true;
    case RosKind::Int32:
      return visit(std::int32_t()), true;
    case RosKind::Uint32:
      return visit(std::uint32_t()), true;
    case RosKind::Int64:
      return visit(std::int64_t()), true;
    case RosKind::Uint64:
      return visit(std::uint64_t()), true;
    case RosKind::Float32:
      return visit(0.0F), true;
    case RosKind::Float64:
      return visit(0.0), true;
    default:
      return false;
  }
}
/// Size in bytes; 0 if it has no fixed size.
inline std::size_t sizeOf(RosKind kind) {
  std::size_t size = 0;
  visitNumber(kind, [&](auto zero) { size = sizeof(zero); });
  return size;
}

struct RosField {
  enum class Many : std::uint8_t { One, Fixed, Open };
  std::string name;
  RosKind kind = RosKind::Flag;
  Many many = Many::One;
  std::uint32_t count = 0;  // of Fixed
  std::size_t type = 0;     // of Nested: RosSchema::types
};

struct RosType {
  std::string name;  // "nav_msgs/Path", also of ROS 2
  std::vector<RosField> fields;
};

struct RosSchema {
  std::vector<RosType> types;  // the message itself first
};

struct RosSchemaFault {
  enum class Code : std::uint8_t {
    TooLong,      // over 1 MiB, or more types, fields or nesting than any real message
    NotAField,    // the line is neither a field nor a constant
    UnknownType,  // `word` is defined nowhere
    HoldsItself,  // the type `word`
  };
  Code code = Code::NotAField;
  std::size_t line = 0;  // from 1; 0: none
  std::string word;      // untrusted
};

enum class RosDialect : std::uint8_t { Ros1, Ros2 };
/// From a schema's encoding in MCAP; nullopt: another one.
std::optional<RosDialect> rosDialect(std::string_view schema_encoding);

/// `name`: of the message, "nav_msgs/Path" or "nav_msgs/msg/Path".
tl::expected<RosSchema, RosSchemaFault> parseRosSchema(std::string_view name, std::string_view definition,
                                                       RosDialect dialect);

}  // namespace mapwright::recording
