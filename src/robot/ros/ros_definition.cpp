#include "robot/ros/ros_definition.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace mapwright::robot::ros {
namespace {

using net::rosbridge::Field;

constexpr std::size_t kMostTypes = 1000, kMostFields = 10'000;

/// ROS 2 gives some types by their IDL names.
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kOfIdl{
    {{"boolean", "bool"}, {"float", "float32"}, {"double", "float64"}, {"octet", "byte"}}};

constexpr std::array<std::string_view, 18> kPlain{
    "bool",  "byte",   "char",    "int8",    "uint8",  "int16",   "uint16", "int32",    "uint32",
    "int64", "uint64", "float32", "float64", "string", "wstring", "time",   "duration", "octet"};

struct Member {
  std::string type, name, array;  // "geometry_msgs/Point", "points", "[]"
};
struct Type {
  std::string name;
  std::vector<Member> members;
};

/// "string<10>" is a "string", "float, 5" a "float".
std::string plainOf(std::string type) {
  type = type.substr(0, type.find_first_of("<,"));
  for (const auto& [idl, plain] : kOfIdl) {
    if (type == idl) return std::string(plain);
  }
  return type;
}

/// "sequence<double, 5>" and "double[5]", where only the type says that it is an array.
Member memberOf(std::string type, std::string name, std::int64_t length) {
  Member member;
  member.name = std::move(name);
  if (length >= 0) member.array = length == 0 ? "[]" : '[' + std::to_string(length) + ']';
  constexpr std::string_view kSequence = "sequence<";
  if (type.starts_with(kSequence)) {
    type = type.substr(kSequence.size(), type.find_last_of('>') - kSequence.size());
    member.array = "[]";
  } else if (const std::size_t bracket = type.find('['); bracket != std::string::npos) {
    member.array = type.substr(bracket);
    type.resize(bracket);
  }
  member.type = plainOf(std::move(type));
  return member;
}

std::optional<Type> typeIn(const Field& told) {
  Type type;
  type.name = told["type"].text();
  std::vector<std::string> names, types;
  std::vector<std::int64_t> lengths;
  told["fieldnames"].each([&](const Field& one) { names.push_back(one.text()); });
  told["fieldtypes"].each([&](const Field& one) { types.push_back(one.text()); });
  told["fieldarraylen"].each([&](const Field& one) { lengths.push_back(one.integer().value_or(-1)); });
  if (type.name.empty() || names.size() != types.size() || names.size() != lengths.size() ||
      names.size() > kMostFields)
    return std::nullopt;
  // ROS 2 gives the names of its own variables: "_header".
  const bool own = std::all_of(names.begin(), names.end(),
                               [](const std::string& name) { return name.size() > 1 && name[0] == '_'; });
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string name = own ? names[i].substr(1) : names[i];
    if (name.empty() || name == "check_fields") continue;
    type.members.push_back(memberOf(types[i], name, lengths[i]));
  }
  return type;
}

void write(std::string& out, const Type& type) {
  // Some readers reject an empty definition.
  if (type.members.empty()) out += "# no fields\n";
  for (const Member& member : type.members) out += member.type + member.array + ' ' + member.name + '\n';
}

void rule(std::string& out, const std::string& type) {
  out += std::string(80, '=') + "\nMSG: " + type + '\n';
}

}  // namespace

std::optional<RosDefinition> definitionIn(const Field& typedefs) {
  std::vector<Type> types;
  bool fine = true;
  typedefs.each([&](const Field& told) {
    if (!fine || types.size() > kMostTypes) return;
    const std::string name = told["type"].text();
    // Built-in types of ROS 1.
    if (name == "time" || name == "duration") return;
    std::optional<Type> type = typeIn(told);
    fine = type.has_value();
    if (type) types.push_back(std::move(*type));
  });
  if (!fine || types.empty()) return std::nullopt;
  RosDefinition definition;
  std::set<std::string> known(kPlain.begin(), kPlain.end());
  known.insert("Header");
  for (const Type& type : types) known.insert(type.name);
  for (const Type& type : types) {
    for (const Member& member : type.members) {
      if (!known.contains(member.type)) return std::nullopt;
      definition.ros2 |= member.type.starts_with("builtin_interfaces/");
    }
  }
  std::set<std::string> written;
  for (const Type& type : types) {
    if (!written.insert(type.name).second) continue;
    if (written.size() > 1) rule(definition.text, type.name);
    write(definition.text, type);
  }
  return definition;
}

RosDefinition definitionAround(const RosDefinition& inner, const std::string& type, const std::string& name) {
  RosDefinition around{inner.ros2, type + ' ' + name + '\n'};
  rule(around.text, type);
  around.text += inner.text;
  return around;
}

}  // namespace mapwright::robot::ros
