#include "simulator/ros/message_types.h"

#include <algorithm>
#include <optional>

namespace mapwright::simulator::ros {
namespace {

enum Use : unsigned {
  kChecked = 1,  // clients send it: in requests, and on topics that they may publish
  kTold = 2,     // rosapi knows its definition
  kBoth = 3
};

struct Definition {
  Use use;
  std::string_view type, fields;  // as ROS 1 has them: "type name", parted by commas
};

constexpr Definition kDefinitions[] = {
    {kBoth, "std_msgs/Header", "uint32 seq,time stamp,string frame_id"},
    {kBoth, "std_msgs/String", "string data"},
    {kBoth, "geometry_msgs/Point", "float64 x,float64 y,float64 z"},
    {kTold, "geometry_msgs/Point32", "float32 x,float32 y,float32 z"},
    {kBoth, "geometry_msgs/Vector3", "float64 x,float64 y,float64 z"},
    {kBoth, "geometry_msgs/Quaternion", "float64 x,float64 y,float64 z,float64 w"},
    {kBoth, "geometry_msgs/Pose", "geometry_msgs/Point position,geometry_msgs/Quaternion orientation"},
    {kBoth, "geometry_msgs/PoseStamped", "std_msgs/Header header,geometry_msgs/Pose pose"},
    {kBoth, "geometry_msgs/PoseWithCovariance", "geometry_msgs/Pose pose,float64[36] covariance"},
    {kBoth, "geometry_msgs/PoseWithCovarianceStamped",
     "std_msgs/Header header,geometry_msgs/PoseWithCovariance pose"},
    {kBoth, "geometry_msgs/Twist", "geometry_msgs/Vector3 linear,geometry_msgs/Vector3 angular"},
    {kTold, "geometry_msgs/TwistWithCovariance", "geometry_msgs/Twist twist,float64[36] covariance"},
    {kTold, "geometry_msgs/Transform", "geometry_msgs/Vector3 translation,geometry_msgs/Quaternion rotation"},
    {kTold, "geometry_msgs/TransformStamped",
     "std_msgs/Header header,string child_frame_id,geometry_msgs/Transform transform"},
    {kTold, "geometry_msgs/Polygon", "geometry_msgs/Point32[] points"},
    {kTold, "geometry_msgs/PolygonStamped", "std_msgs/Header header,geometry_msgs/Polygon polygon"},
    {kTold, "tf2_msgs/TFMessage", "geometry_msgs/TransformStamped[] transforms"},
    {kTold, "nav_msgs/Path", "std_msgs/Header header,geometry_msgs/PoseStamped[] poses"},
    {kTold, "nav_msgs/Odometry",
     "std_msgs/Header header,string child_frame_id,geometry_msgs/PoseWithCovariance pose,"
     "geometry_msgs/TwistWithCovariance twist"},
    {kTold, "nav_msgs/MapMetaData",
     "time map_load_time,float32 resolution,uint32 width,uint32 height,geometry_msgs/Pose origin"},
    {kTold, "nav_msgs/OccupancyGrid", "std_msgs/Header header,nav_msgs/MapMetaData info,int8[] data"},
    {kTold, "map_msgs/OccupancyGridUpdate",
     "std_msgs/Header header,int32 x,int32 y,uint32 width,uint32 height,int8[] data"},
    {kTold, "map_msgs/ProjectedMap", "nav_msgs/OccupancyGrid map,float64 min_z,float64 max_z"},
    {kTold, "sensor_msgs/LaserScan",
     "std_msgs/Header header,float32 angle_min,float32 angle_max,float32 angle_increment,"
     "float32 time_increment,float32 scan_time,float32 range_min,float32 range_max,float32[] ranges,"
     "float32[] intensities"},
    {kTold, "sensor_msgs/PointField", "string name,uint32 offset,uint8 datatype,uint32 count"},
    {kTold, "sensor_msgs/PointCloud2",
     "std_msgs/Header header,uint32 height,uint32 width,sensor_msgs/PointField[] fields,bool is_bigendian,"
     "uint32 point_step,uint32 row_step,uint8[] data,bool is_dense"},
    {kTold, "std_msgs/ColorRGBA", "float32 r,float32 g,float32 b,float32 a"},
    {kTold, "visualization_msgs/Marker",
     "std_msgs/Header header,string ns,int32 id,int32 type,int32 action,geometry_msgs/Pose pose,"
     "geometry_msgs/Vector3 scale,std_msgs/ColorRGBA color,duration lifetime,bool frame_locked,"
     "geometry_msgs/Point[] points,std_msgs/ColorRGBA[] colors,string text,string mesh_resource,"
     "bool mesh_use_embedded_materials"},
    {kTold, "visualization_msgs/MarkerArray", "visualization_msgs/Marker[] markers"},
    {kTold, "kabam_msgs/Map", "string map_name,string map_label,string map_id"},
    {kTold, "kabam_msgs/MapList", "kabam_msgs/Map[] maps"},
    {kTold, "kabam_msgs/MapInfo",
     "string map_id,string map_name,string map_label,string updated_at,string created_at,"
     "string map_manager_state"},
    {kBoth, "kabam_msgs/MapWaypoint",
     "string name,string id,string frame_id,geometry_msgs/Pose pose,string map_id,string[] waypoint_tags"},
    {kTold, "kabam_msgs/MapWaypointList", "kabam_msgs/MapWaypoint[] waypoints"},
    {kTold, "builtin_interfaces/Time", "int32 sec,uint32 nanosec"},
    {kTold, "builtin_interfaces/Duration", "int32 sec,uint32 nanosec"},
    {kTold, "time", "int32 secs,int32 nsecs"},
    {kTold, "duration", "int32 secs,int32 nsecs"},
    {kChecked, "time of ROS 1", "uint32 secs,uint32 nsecs"},
    {kChecked, "time of ROS 2", "int32 sec,uint32 nanosec"},
    {kChecked, "sensor_msgs/Image",
     "std_msgs/Header header,uint32 height,uint32 width,string encoding,uint8 is_bigendian,uint32 step,"
     "uint8[] data"},
    {kChecked, "std_srvs/TriggerRequest", ""},
    {kChecked, "nav_msgs/GetMapRequest", ""},
    {kChecked, "map_msgs/SaveMapRequest", "std_msgs/String filename"},
    {kChecked, "map_msgs/GetMapROIRequest", "float64 x,float64 y,float64 l_x,float64 l_y"},
    {kChecked, "map_msgs/GetPointMapRequest", ""},
    {kChecked, "map_msgs/GetPointMapROIRequest",
     "float64 x,float64 y,float64 z,float64 r,float64 l_x,float64 l_y,float64 l_z"},
    {kChecked, "map_msgs/SetMapProjectionsRequest", ""},
    {kChecked, "map_msgs/ProjectedMapInfo",
     "string frame_id,float64 x,float64 y,float64 width,float64 height,float64 min_z,float64 max_z"},
    {kChecked, "map_msgs/ProjectedMapsInfoRequest", "map_msgs/ProjectedMapInfo[] projected_maps_info"},
    {kChecked, "kabam_msgs/SaveMapRequest", "string map_name"},
    {kChecked, "kabam_msgs/LoadMapRequest", "string map_id,string loc_waypoint_name"},
    {kChecked, "kabam_msgs/UpdateMapRequest",
     "string map_id,sensor_msgs/Image updated_image,string new_map_label,bool set_archive,bool delete_map"},
    {kChecked, "kabam_msgs/ManageWaypointRequest",
     "kabam_msgs/MapWaypoint waypoint_info,bool delete_waypoint"},
    {kChecked, "kabam_msgs/GetWaypointRequest", "string map_id,string waypoint_id"},
    {kChecked, "rosapi/TopicsRequest", ""},
    {kChecked, "rosapi/TopicTypeRequest", "string topic"},
    {kChecked, "rosapi/MessageDetailsRequest", "string type"},
    {kChecked, "rosapi/TopicsForTypeRequest", "string type"},
    {kChecked, "rosapi/ServicesRequest", ""},
    {kChecked, "rosapi/ServiceTypeRequest", "string service"},
    {kChecked, "rosapi/NodesRequest", ""}};

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

std::string ros2Type(const std::string& type) {
  if (type == "time") return "builtin_interfaces/Time";
  if (type == "duration") return "builtin_interfaces/Duration";
  if (type == "bool") return "boolean";
  if (type == "float32") return "float";
  return type == "float64" ? "double" : type;
}

}  // namespace

MessageTypes::MessageTypes(RosDialect dialect) : dialect_(dialect) {
  for (const Definition& definition : kDefinitions) {
    Type& type = types_[std::string(definition.type)];
    type.use = definition.use;
    std::string_view rest = definition.fields;
    while (!rest.empty()) {
      const std::string_view one = rest.substr(0, rest.find(','));
      rest.remove_prefix(std::min(rest.size(), one.size() + 1));
      const std::size_t blank = one.find(' ');
      Field field{std::string(one.substr(0, blank)), std::string(one.substr(blank + 1))};
      if (const std::size_t bracket = field.type.find('['); bracket != std::string::npos) {
        field.length = bracket + 2 == field.type.size() ? 0 : std::stoi(field.type.substr(bracket + 1));
        field.type.resize(bracket);
      }
      if (field.name != "seq" || dialect == RosDialect::Ros1) type.fields.push_back(std::move(field));
    }
  }
}

const std::vector<MessageTypes::Field>* MessageTypes::checkedFields(std::string_view type) const {
  if (type == "time") type = dialect_ == RosDialect::Ros1 ? "time of ROS 1" : "time of ROS 2";
  const auto found = types_.find(type);
  return found == types_.end() || (found->second.use & kChecked) == 0 ? nullptr : &found->second.fields;
}

Answer MessageTypes::complete(std::string_view type, const Value& given) const {
  const std::vector<Field>* const fields = checkedFields(type);
  if (fields == nullptr) return tl::make_unexpected("Unable to load the manifest for " + std::string(type));
  static const Value::Object nothing;
  const Value::Object* members = given.isNull() ? &nothing : given.as<Value::Object>();
  if (members == nullptr) return tl::make_unexpected(mismatch(type, "dict", "(message)", given));
  for (const auto& [name, value] : *members) {
    const bool known = std::any_of(fields->begin(), fields->end(),
                                   [&name = name](const Field& field) { return field.name == name; });
    if (!known) {
      return tl::make_unexpected("Message type " + std::string(type) + " does not have a field " + name);
    }
  }
  Value::Object whole;
  for (const Field& field : *fields) {
    const Value* const member = given.has(field.name) ? &given[field.name] : nullptr;
    Answer value = field.isList() ? list(type, field, member) : single(type, field, member);
    if (!value) return value;
    whole.emplace_back(field.name, std::move(*value));
  }
  return whole;
}

Answer MessageTypes::fromList(std::string_view type, const Value::List& given) const {
  const std::vector<Field>* const fields = checkedFields(type);
  if (fields == nullptr || given.size() > fields->size())
    return tl::make_unexpected("Message type " + std::string(type) + " does not have so many fields");
  Value::Object named;
  for (std::size_t i = 0; i < given.size(); ++i) named.emplace_back((*fields)[i].name, given[i]);
  return complete(type, named);
}

Answer MessageTypes::list(std::string_view type, const Field& field, const Value* given) const {
  const bool is_bytes = field.type == "uint8";
  if (given == nullptr) return is_bytes ? Value(Value::Bytes{}) : Value(Value::List{});
  const auto refuse = [&] {
    return tl::make_unexpected(mismatch(type, field.type + "[]", field.name, *given));
  };
  if (const std::string* text = given->as<std::string>(); is_bytes && text != nullptr) {
    std::optional<std::string> bytes = fromBase64(*text);
    if (!bytes) return refuse();
    return Value::Bytes{std::move(*bytes)};
  }
  const Value::List* items = given->as<Value::List>();
  if (items == nullptr) return refuse();
  Value::List read;
  std::string bytes;
  for (const Value& item : *items) {
    Answer value = single(type, field, &item);
    if (!value) return value;
    if (is_bytes) {
      bytes += static_cast<char>(static_cast<unsigned char>(value->number()));
    } else {
      read.push_back(std::move(*value));
    }
  }
  return is_bytes ? Value(Value::Bytes{std::move(bytes)}) : Value(std::move(read));
}

Answer MessageTypes::single(std::string_view type, const Field& field, const Value* given) const {
  const auto checked = [&](bool fits) -> Answer {
    if (fits) return *given;
    return tl::make_unexpected(mismatch(type, field.type, field.name, *given));
  };
  if (field.type == "bool") return given == nullptr ? Value(false) : checked(given->as<bool>() != nullptr);
  if (field.type == "string")
    return given == nullptr ? Value("") : checked(given->as<std::string>() != nullptr);
  if (field.type == "float64") {
    if (given == nullptr || given->isNumber()) return Value(given == nullptr ? 0.0 : given->number());
    return checked(false);
  }
  if (const std::optional<Range> range = rangeOf(field.type)) {
    if (given == nullptr) return Value(0);
    return checked(given->as<std::int64_t>() != nullptr && given->number() >= range->low &&
                   given->number() <= range->high);
  }
  if (given != nullptr && given->as<Value::Object>() == nullptr) return checked(false);
  return complete(field.type, given != nullptr ? *given : Value());
}

/// The type and, behind it, those of its fields that are not listed yet.
void MessageTypes::listTypes(Value::List& all, std::set<std::string>& seen, const std::string& type) const {
  const auto found = types_.find(type);
  if (found == types_.end() || (found->second.use & kTold) == 0 || !seen.insert(type).second) return;
  const bool is_ros1 = dialect_ == RosDialect::Ros1;
  Value::List names, types, lengths, examples;
  for (const Field& field : found->second.fields) {
    names.emplace_back(is_ros1 ? field.name : "_" + field.name);
    types.emplace_back(is_ros1 ? field.type : ros2Type(field.type));
    lengths.emplace_back(field.length);
    examples.emplace_back(field.isList() ? "[]" : "0");
  }
  all.push_back(Value::Object{{"type", type},
                              {"fieldnames", std::move(names)},
                              {"fieldtypes", types},
                              {"fieldarraylen", std::move(lengths)},
                              {"examples", std::move(examples)},
                              {"constnames", Value::List{}},
                              {"constvalues", Value::List{}}});
  for (const Value& inside : types) listTypes(all, seen, inside.text());
}

Value MessageTypes::details(std::string_view type) const {
  std::string plain(type);
  if (const std::size_t middle = plain.find("/msg/");
      middle != std::string::npos && dialect_ == RosDialect::Ros2)
    plain.erase(middle, 4);
  Value::List typedefs;
  std::set<std::string> seen;
  listTypes(typedefs, seen, plain);
  return Value::Object{{"typedefs", std::move(typedefs)}};
}

std::string typeName(std::string_view plain, std::string_view kind, RosDialect dialect) {
  std::string name(plain);
  const std::size_t slash = name.find('/');
  if (dialect == RosDialect::Ros2 && slash != std::string::npos)
    name.insert(slash + 1, std::string(kind) + "/");
  return name;
}

}  // namespace mapwright::simulator::ros
