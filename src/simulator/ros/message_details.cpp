#include "simulator/ros/message_details.h"

#include <set>
#include <string>

namespace mapwright::simulator::ros {
namespace {

struct MessageText {
  std::string_view type, fields;  // as ROS 1 has them: "type name", parted by commas
};

constexpr MessageText kMessages[] = {
    {"std_msgs/Header", "uint32 seq,time stamp,string frame_id"},
    {"std_msgs/String", "string data"},
    {"geometry_msgs/Point", "float64 x,float64 y,float64 z"},
    {"geometry_msgs/Point32", "float32 x,float32 y,float32 z"},
    {"geometry_msgs/Vector3", "float64 x,float64 y,float64 z"},
    {"geometry_msgs/Quaternion", "float64 x,float64 y,float64 z,float64 w"},
    {"geometry_msgs/Pose", "geometry_msgs/Point position,geometry_msgs/Quaternion orientation"},
    {"geometry_msgs/PoseStamped", "std_msgs/Header header,geometry_msgs/Pose pose"},
    {"geometry_msgs/PoseWithCovariance", "geometry_msgs/Pose pose,float64[36] covariance"},
    {"geometry_msgs/PoseWithCovarianceStamped",
     "std_msgs/Header header,geometry_msgs/PoseWithCovariance pose"},
    {"geometry_msgs/Twist", "geometry_msgs/Vector3 linear,geometry_msgs/Vector3 angular"},
    {"geometry_msgs/TwistWithCovariance", "geometry_msgs/Twist twist,float64[36] covariance"},
    {"geometry_msgs/Transform", "geometry_msgs/Vector3 translation,geometry_msgs/Quaternion rotation"},
    {"geometry_msgs/TransformStamped",
     "std_msgs/Header header,string child_frame_id,geometry_msgs/Transform transform"},
    {"geometry_msgs/Polygon", "geometry_msgs/Point32[] points"},
    {"geometry_msgs/PolygonStamped", "std_msgs/Header header,geometry_msgs/Polygon polygon"},
    {"tf2_msgs/TFMessage", "geometry_msgs/TransformStamped[] transforms"},
    {"nav_msgs/Path", "std_msgs/Header header,geometry_msgs/PoseStamped[] poses"},
    {"nav_msgs/Odometry",
     "std_msgs/Header header,string child_frame_id,geometry_msgs/PoseWithCovariance pose,"
     "geometry_msgs/TwistWithCovariance twist"},
    {"nav_msgs/MapMetaData",
     "time map_load_time,float32 resolution,uint32 width,uint32 height,geometry_msgs/Pose origin"},
    {"nav_msgs/OccupancyGrid", "std_msgs/Header header,nav_msgs/MapMetaData info,int8[] data"},
    {"map_msgs/OccupancyGridUpdate",
     "std_msgs/Header header,int32 x,int32 y,uint32 width,uint32 height,int8[] data"},
    {"map_msgs/ProjectedMap", "nav_msgs/OccupancyGrid map,float64 min_z,float64 max_z"},
    {"sensor_msgs/LaserScan",
     "std_msgs/Header header,float32 angle_min,float32 angle_max,float32 angle_increment,"
     "float32 time_increment,float32 scan_time,float32 range_min,float32 range_max,float32[] ranges,"
     "float32[] intensities"},
    {"sensor_msgs/PointField", "string name,uint32 offset,uint8 datatype,uint32 count"},
    {"sensor_msgs/PointCloud2",
     "std_msgs/Header header,uint32 height,uint32 width,sensor_msgs/PointField[] fields,bool is_bigendian,"
     "uint32 point_step,uint32 row_step,uint8[] data,bool is_dense"},
    {"std_msgs/ColorRGBA", "float32 r,float32 g,float32 b,float32 a"},
    {"visualization_msgs/Marker",
     "std_msgs/Header header,string ns,int32 id,int32 type,int32 action,geometry_msgs/Pose pose,"
     "geometry_msgs/Vector3 scale,std_msgs/ColorRGBA color,duration lifetime,bool frame_locked,"
     "geometry_msgs/Point[] points,std_msgs/ColorRGBA[] colors,string text,string mesh_resource,"
     "bool mesh_use_embedded_materials"},
    {"visualization_msgs/MarkerArray", "visualization_msgs/Marker[] markers"},
    {"kabam_msgs/Map", "string map_name,string map_label,string map_id"},
    {"kabam_msgs/MapList", "kabam_msgs/Map[] maps"},
    {"kabam_msgs/MapInfo",
     "string map_id,string map_name,string map_label,string updated_at,string created_at,"
     "string map_manager_state"},
    {"kabam_msgs/MapWaypoint",
     "string name,string id,string frame_id,geometry_msgs/Pose pose,string map_id,string[] waypoint_tags"},
    {"kabam_msgs/MapWaypointList", "kabam_msgs/MapWaypoint[] waypoints"},
    {"builtin_interfaces/Time", "int32 sec,uint32 nanosec"},
    {"builtin_interfaces/Duration", "int32 sec,uint32 nanosec"},
    {"time", "int32 secs,int32 nsecs"},
    {"duration", "int32 secs,int32 nsecs"}};

struct FieldLists {
  Value::List names, types, lengths, examples;
};

std::string ros2Type(const std::string& type) {
  if (type == "time") return "builtin_interfaces/Time";
  if (type == "duration") return "builtin_interfaces/Duration";
  if (type == "bool") return "boolean";
  if (type == "float32") return "float";
  return type == "float64" ? "double" : type;
}

/// The type and, behind it, those of its fields that are not listed yet.
void listTypes(Value::List& all, std::set<std::string>& seen, const std::string& type, RosDialect dialect) {
  const MessageText* found = nullptr;
  for (const MessageText& one : kMessages) {
    if (one.type == type) found = &one;
  }
  if (found == nullptr || !seen.insert(type).second) return;
  const bool ros2 = dialect == RosDialect::Ros2;
  FieldLists lists;
  std::vector<std::string> inside;
  std::string_view rest = found->fields;
  while (!rest.empty()) {
    const std::string_view one = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(rest.size(), one.size() + 1));
    const std::size_t blank = one.find(' ');
    std::string of(one.substr(0, blank)), name(one.substr(blank + 1));
    if (ros2 && name == "seq") continue;
    std::int64_t length = -1;
    if (const std::size_t bracket = of.find('['); bracket != std::string::npos) {
      length = bracket + 2 == of.size() ? 0 : std::stoi(of.substr(bracket + 1));
      of.resize(bracket);
    }
    if (ros2) {
      of = ros2Type(of);
      name.insert(0, "_");
    }
    inside.push_back(of);
    lists.names.emplace_back(std::move(name));
    lists.types.emplace_back(std::move(of));
    lists.lengths.emplace_back(length);
    lists.examples.emplace_back(length < 0 ? "0" : "[]");
  }
  all.push_back(Value::Object{{"type", type},
                              {"fieldnames", std::move(lists.names)},
                              {"fieldtypes", std::move(lists.types)},
                              {"fieldarraylen", std::move(lists.lengths)},
                              {"examples", std::move(lists.examples)},
                              {"constnames", Value::List{}},
                              {"constvalues", Value::List{}}});
  for (const std::string& of : inside) listTypes(all, seen, of, dialect);
}

}  // namespace

Value messageDetails(std::string_view type, RosDialect dialect) {
  std::string plain(type);
  if (const std::size_t middle = plain.find("/msg/");
      middle != std::string::npos && dialect == RosDialect::Ros2)
    plain.erase(middle, 4);
  Value::List typedefs;
  std::set<std::string> seen;
  listTypes(typedefs, seen, plain, dialect);
  return Value::Object{{"typedefs", std::move(typedefs)}};
}

}  // namespace mapwright::simulator::ros
