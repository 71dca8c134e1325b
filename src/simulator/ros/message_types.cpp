#include "simulator/ros/message_types.h"

#include <cmath>
#include <limits>
#include <optional>

#include "simulator/value_json.h"

namespace mapwright::simulator::ros {
namespace {

struct Definition {
  std::string_view type, fields;  // fields as "type name", parted by commas
};

/// What clients send to this robot: requests, and messages of topics that they may publish.
constexpr Definition kDefinitions[] = {
    {"std_msgs/Header", "uint32 seq,time stamp,string frame_id"},
    {"std_msgs/String", "string data"},
    {"geometry_msgs/Point", "float64 x,float64 y,float64 z"},
    {"geometry_msgs/Vector3", "float64 x,float64 y,float64 z"},
    {"geometry_msgs/Quaternion", "float64 x,float64 y,float64 z,float64 w"},
    {"geometry_msgs/Pose", "geometry_msgs/Point position,geometry_msgs/Quaternion orientation"},
    {"geometry_msgs/PoseStamped", "std_msgs/Header header,geometry_msgs/Pose pose"},
    {"geometry_msgs/PoseWithCovariance", "geometry_msgs/Pose pose,float64[] covariance"},
    {"geometry_msgs/PoseWithCovarianceStamped",
     "std_msgs/Header header,geometry_msgs/PoseWithCovariance pose"},
    {"geometry_msgs/Twist", "geometry_msgs/Vector3 linear,geometry_msgs/Vector3 angular"},
    {"sensor_msgs/Image",
     "std_msgs/Header header,uint32 height,uint32 width,string encoding,uint8 is_bigendian,uint32 step,"
     "uint8[] data"},
    {"std_srvs/TriggerRequest", ""},
    {"nav_msgs/GetMapRequest", ""},
    {"map_msgs/SaveMapRequest", "std_msgs/String filename"},
    {"map_msgs/GetMapROIRequest", "float64 x,float64 y,float64 l_x,float64 l_y"},
    {"map_msgs/GetPointMapRequest", ""},
    {"map_msgs/GetPointMapROIRequest",
     "float64 x,float64 y,float64 z,float64 r,float64 l_x,float64 l_y,float64 l_z"},
    {"map_msgs/SetMapProjectionsRequest", ""},
    {"map_msgs/ProjectedMapInfo",
     "string frame_id,float64 x,float64 y,float64 width,float64 height,float64 min_z,float64 max_z"},
    {"map_msgs/ProjectedMapsInfoRequest", "map_msgs/ProjectedMapInfo[] projected_maps_info"},
    {"kabam_msgs/MapWaypoint",
     "string name,string id,string frame_id,geometry_msgs/Pose pose,string map_id,string[] waypoint_tags"},
    {"kabam_msgs/SaveMapRequest", "string map_name"},
    {"kabam_msgs/LoadMapRequest", "string map_id,string loc_waypoint_name"},
    {"kabam_msgs/UpdateMapRequest",
     "string map_id,sensor_msgs/Image updated_image,string new_map_label,bool set_archive,bool delete_map"},
    {"kabam_msgs/ManageWaypointRequest", "kabam_msgs/MapWaypoint waypoint_info,bool delete_waypoint"},
    {"kabam_msgs/GetWaypointRequest", "string map_id,string waypoint_id"},
    {"rosapi/TopicsRequest", ""},
    {"rosapi/TopicTypeRequest", "string topic"},
    {"rosapi/MessageDetailsRequest", "string type"},
    {"rosapi/TopicsForTypeRequest", "string type"},
    {"rosapi/ServicesRequest", ""},
    {"rosapi/ServiceTypeRequest", "string service"},
    {"rosapi/NodesRequest", ""}};

struct Range {
  double low, high;
};

std::optional<Range> rangeOf(std::string_view type) {
  if (type == "uint8") return Range{0, 255};
  if (type == "int8") return Range{-128, 127};
  if (type == "int32") return Range{-2147483648.0, 2147483647.0};
  if (type == "uint32") return Range{0, 4294967295.0};
  return std::nullopt;
}

std::string kindOf(const Value& value) {
  static constexpr const char* kNames[] = {"NoneType", "bool", "int",  "float", "str",  "list",
                                           "dict",     "str",  "list", "list",  "list", "str"};
  return kNames[value.data().index()];
}

std::string mismatch(std::string_view type, std::string_view wanted, std::string_view name,
                     const Value& given) {
  return std::string(type) + " message requires a " + std::string(wanted) + " for field " +
         std::string(name) + ", but got a " + kindOf(given);
}

}  // namespace

MessageTypes::MessageTypes(RosDialect dialect) {
  const bool is_ros1 = dialect == RosDialect::Ros1;
  for (const Definition& definition : kDefinitions) {
    std::vector<Field>& fields = types_[std::string(definition.type)];
    std::string_view rest = definition.fields;
    while (!rest.empty()) {
      const std::string_view one = rest.substr(0, rest.find(','));
      rest.remove_prefix(std::min(rest.size(), one.size() + 1));
      const std::size_t blank = one.find(' ');
      Field field{std::string(one.substr(0, blank)), std::string(one.substr(blank + 1)), false};
      if (field.type.ends_with("[]")) {
        field.is_list = true;
        field.type.resize(field.type.size() - 2);
      }
      if (field.name != "seq" || is_ros1) fields.push_back(std::move(field));
    }
  }
  types_["time"] = is_ros1 ? std::vector<Field>{{"uint32", "secs", false}, {"uint32", "nsecs", false}}
                           : std::vector<Field>{{"int32", "sec", false}, {"uint32", "nanosec", false}};
}

MessageTypes::Read MessageTypes::complete(std::string_view type, const Value& given) const {
  const auto found = types_.find(type);
  if (found == types_.end())
    return tl::make_unexpected("Unable to load the manifest for " + std::string(type));
  static const Value::Object nothing;
  const Value::Object* members = given.isNull() ? &nothing : given.as<Value::Object>();
  if (members == nullptr) return tl::make_unexpected(mismatch(type, "dict", "(message)", given));
  for (const auto& [name, value] : *members) {
    const bool known = std::any_of(found->second.begin(), found->second.end(),
                                   [&name = name](const Field& field) { return field.name == name; });
    if (!known) {
      return tl::make_unexpected("Message type " + std::string(type) + " does not have a field " + name);
    }
  }
  Value::Object whole;
  for (const Field& one : found->second) {
    Read value = field(type, one, given.has(one.name) ? &given[one.name] : nullptr);
    if (!value) return value;
    whole.emplace_back(one.name, std::move(*value));
  }
  return Value(std::move(whole));
}

MessageTypes::Read MessageTypes::fromList(std::string_view type, const Value::List& given) const {
  const auto found = types_.find(type);
  if (found == types_.end() || given.size() > found->second.size())
    return tl::make_unexpected("Message type " + std::string(type) + " does not have so many fields");
  Value::Object named;
  for (std::size_t i = 0; i < given.size(); ++i) named.emplace_back(found->second[i].name, given[i]);
  return complete(type, named);
}

MessageTypes::Read MessageTypes::field(std::string_view type, const Field& field, const Value* given) const {
  return field.is_list ? list(type, field, given) : single(type, field, given);
}

MessageTypes::Read MessageTypes::list(std::string_view type, const Field& field, const Value* given) const {
  const std::string wanted = field.type + "[]";
  const Value::List* items = given != nullptr ? given->as<Value::List>() : nullptr;
  if (field.type == "uint8") {
    if (given == nullptr) return Value(Value::Bytes{});
    if (const std::string* text = given->as<std::string>()) {
      std::optional<std::string> bytes = fromBase64(*text);
      if (!bytes) return tl::make_unexpected(mismatch(type, wanted, field.name, *given));
      return Value(Value::Bytes{std::move(*bytes)});
    }
  }
  if (given == nullptr) return Value(Value::List{});
  if (items == nullptr) return tl::make_unexpected(mismatch(type, wanted, field.name, *given));
  Value::List read;
  std::string bytes;
  for (const Value& item : *items) {
    Read value = single(type, field, &item);
    if (!value) return value;
    if (field.type == "uint8") {
      bytes += static_cast<char>(static_cast<unsigned char>(value->number()));
    } else {
      read.push_back(std::move(*value));
    }
  }
  if (field.type == "uint8") return Value(Value::Bytes{std::move(bytes)});
  return Value(std::move(read));
}

MessageTypes::Read MessageTypes::single(std::string_view type, const Field& field, const Value* given) const {
  const auto refuse = [&] { return tl::make_unexpected(mismatch(type, field.type, field.name, *given)); };
  if (field.type == "bool") {
    if (given == nullptr) return Value(false);
    if (given->as<bool>() == nullptr) return refuse();
    return *given;
  }
  if (field.type == "string") {
    if (given == nullptr) return Value("");
    if (given->as<std::string>() == nullptr) return refuse();
    return *given;
  }
  if (field.type == "float64") {
    if (given == nullptr) return Value(0.0);
    if (!given->isNumber()) return refuse();
    return Value(given->number());
  }
  if (const std::optional<Range> range = rangeOf(field.type)) {
    if (given == nullptr) return Value(0);
    const std::int64_t* number = given->as<std::int64_t>();
    if (number == nullptr || given->number() < range->low || given->number() > range->high) return refuse();
    return *given;
  }
  if (given != nullptr && given->as<Value::Object>() == nullptr) return refuse();
  return complete(field.type, given != nullptr ? *given : Value());
}

std::string typeName(std::string_view plain, std::string_view kind, RosDialect dialect) {
  std::string name(plain);
  const std::size_t slash = name.find('/');
  if (dialect == RosDialect::Ros2 && slash != std::string::npos)
    name.insert(slash + 1, std::string(kind) + "/");
  return name;
}

bool sameType(std::string_view named, std::string_view plain, std::string_view kind, RosDialect dialect) {
  return named == plain || named == typeName(plain, kind, dialect);
}

}  // namespace mapwright::simulator::ros
