#include "recording/known_definitions.h"

#include <algorithm>
#include <set>

#include "recording/ros_cbor.h"
#include "recording/ros_schema.h"

namespace mapwright::recording {
namespace {

struct KnownType {
  std::string_view name;
  const char* fields;  // "type name;…"
};

// A type that is listed again had other fields in older releases.
constexpr KnownType kTypes[] = {
    {"builtin_interfaces/Time", "int32 sec;uint32 nanosec"},
    {"builtin_interfaces/Duration", "int32 sec;uint32 nanosec"},
    {"std_msgs/Header", "builtin_interfaces/Time stamp;string frame_id"},
    {"std_msgs/Bool", "bool data"},
    {"std_msgs/Byte", "byte data"},
    {"std_msgs/Char", "char data"},
    {"std_msgs/ColorRGBA", "float32 r;float32 g;float32 b;float32 a"},
    {"std_msgs/Empty", ""},
    {"std_msgs/Float32", "float32 data"},
    {"std_msgs/Float64", "float64 data"},
    {"std_msgs/Int8", "int8 data"},
    {"std_msgs/Int16", "int16 data"},
    {"std_msgs/Int32", "int32 data"},
    {"std_msgs/Int64", "int64 data"},
    {"std_msgs/UInt8", "uint8 data"},
    {"std_msgs/UInt16", "uint16 data"},
    {"std_msgs/UInt32", "uint32 data"},
    {"std_msgs/UInt64", "uint64 data"},
    {"std_msgs/String", "string data"},
    {"std_msgs/MultiArrayDimension", "string label;uint32 size;uint32 stride"},
    {"std_msgs/MultiArrayLayout", "MultiArrayDimension[] dim;uint32 data_offset"},
    {"std_msgs/Float32MultiArray", "MultiArrayLayout layout;float32[] data"},
    {"std_msgs/Float64MultiArray", "MultiArrayLayout layout;float64[] data"},
    {"std_msgs/Int32MultiArray", "MultiArrayLayout layout;int32[] data"},
    {"std_msgs/UInt8MultiArray", "MultiArrayLayout layout;uint8[] data"},
    {"geometry_msgs/Point", "float64 x;float64 y;float64 z"},
    {"geometry_msgs/Point32", "float32 x;float32 y;float32 z"},
    {"geometry_msgs/PointStamped", "std_msgs/Header header;Point point"},
    {"geometry_msgs/Polygon", "Point32[] points"},
    {"geometry_msgs/PolygonStamped", "std_msgs/Header header;Polygon polygon"},
    {"geometry_msgs/Quaternion", "float64 x;float64 y;float64 z;float64 w"},
    {"geometry_msgs/QuaternionStamped", "std_msgs/Header header;Quaternion quaternion"},
    {"geometry_msgs/Vector3", "float64 x;float64 y;float64 z"},
    {"geometry_msgs/Vector3Stamped", "std_msgs/Header header;Vector3 vector"},
    {"geometry_msgs/Pose", "Point position;Quaternion orientation"},
    {"geometry_msgs/Pose2D", "float64 x;float64 y;float64 theta"},
    {"geometry_msgs/PoseArray", "std_msgs/Header header;Pose[] poses"},
    {"geometry_msgs/PoseStamped", "std_msgs/Header header;Pose pose"},
    {"geometry_msgs/PoseWithCovariance", "Pose pose;float64[36] covariance"},
    {"geometry_msgs/PoseWithCovarianceStamped", "std_msgs/Header header;PoseWithCovariance pose"},
    {"geometry_msgs/Transform", "Vector3 translation;Quaternion rotation"},
    {"geometry_msgs/TransformStamped", "std_msgs/Header header;string child_frame_id;Transform transform"},
    {"geometry_msgs/Twist", "Vector3 linear;Vector3 angular"},
    {"geometry_msgs/TwistStamped", "std_msgs/Header header;Twist twist"},
    {"geometry_msgs/TwistWithCovariance", "Twist twist;float64[36] covariance"},
    {"geometry_msgs/TwistWithCovarianceStamped", "std_msgs/Header header;TwistWithCovariance twist"},
    {"geometry_msgs/Accel", "Vector3 linear;Vector3 angular"},
    {"geometry_msgs/AccelStamped", "std_msgs/Header header;Accel accel"},
    {"geometry_msgs/Wrench", "Vector3 force;Vector3 torque"},
    {"geometry_msgs/WrenchStamped", "std_msgs/Header header;Wrench wrench"},
    {"nav_msgs/MapMetaData",
     "builtin_interfaces/Time map_load_time;float32 resolution;uint32 width;uint32 height;geometry_msgs/Pose "
     "origin"},
    {"nav_msgs/OccupancyGrid", "std_msgs/Header header;MapMetaData info;int8[] data"},
    {"nav_msgs/GridCells",
     "std_msgs/Header header;float32 cell_width;float32 cell_height;geometry_msgs/Point[] cells"},
    {"nav_msgs/Odometry",
     "std_msgs/Header header;string child_frame_id;geometry_msgs/PoseWithCovariance pose;"
     "geometry_msgs/TwistWithCovariance twist"},
    {"nav_msgs/Path", "std_msgs/Header header;geometry_msgs/PoseStamped[] poses"},
    {"map_msgs/OccupancyGridUpdate",
     "std_msgs/Header header;int32 x;int32 y;uint32 width;uint32 height;int8[] data"},
    {"map_msgs/PointCloud2Update", "std_msgs/Header header;uint32 type;sensor_msgs/PointCloud2 points"},
    {"map_msgs/ProjectedMap", "nav_msgs/OccupancyGrid map;float64 min_z;float64 max_z"},
    {"sensor_msgs/BatteryState",
     "std_msgs/Header header;float32 voltage;float32 temperature;float32 current;float32 charge;float32 "
     "capacity;"
     "float32 design_capacity;float32 percentage;uint8 power_supply_status;uint8 power_supply_health;"
     "uint8 power_supply_technology;bool present;float32[] cell_voltage;float32[] cell_temperature;string "
     "location;"
     "string serial_number"},
    {"sensor_msgs/BatteryState",
     "std_msgs/Header header;float32 voltage;float32 current;float32 charge;float32 capacity;"
     "float32 design_capacity;float32 percentage;uint8 power_supply_status;uint8 power_supply_health;"
     "uint8 power_supply_technology;bool present;float32[] cell_voltage;string location;string "
     "serial_number"},
    {"sensor_msgs/RegionOfInterest",
     "uint32 x_offset;uint32 y_offset;uint32 height;uint32 width;bool do_rectify"},
    {"sensor_msgs/CameraInfo",
     "std_msgs/Header header;uint32 height;uint32 width;string distortion_model;float64[] d;float64[9] k;"
     "float64[9] r;float64[12] p;uint32 binning_x;uint32 binning_y;RegionOfInterest roi"},
    {"sensor_msgs/ChannelFloat32", "string name;float32[] values"},
    {"sensor_msgs/CompressedImage", "std_msgs/Header header;string format;uint8[] data"},
    {"sensor_msgs/Image",
     "std_msgs/Header header;uint32 height;uint32 width;string encoding;uint8 is_bigendian;uint32 "
     "step;uint8[] data"},
    {"sensor_msgs/Imu",
     "std_msgs/Header header;geometry_msgs/Quaternion orientation;float64[9] orientation_covariance;"
     "geometry_msgs/Vector3 angular_velocity;float64[9] angular_velocity_covariance;"
     "geometry_msgs/Vector3 linear_acceleration;float64[9] linear_acceleration_covariance"},
    {"sensor_msgs/JointState",
     "std_msgs/Header header;string[] name;float64[] position;float64[] velocity;float64[] effort"},
    {"sensor_msgs/Joy", "std_msgs/Header header;float32[] axes;int32[] buttons"},
    {"sensor_msgs/LaserEcho", "float32[] echoes"},
    {"sensor_msgs/LaserScan",
     "std_msgs/Header header;float32 angle_min;float32 angle_max;float32 angle_increment;float32 "
     "time_increment;"
     "float32 scan_time;float32 range_min;float32 range_max;float32[] ranges;float32[] intensities"},
    {"sensor_msgs/MultiEchoLaserScan",
     "std_msgs/Header header;float32 angle_min;float32 angle_max;float32 angle_increment;float32 "
     "time_increment;"
     "float32 scan_time;float32 range_min;float32 range_max;LaserEcho[] ranges;LaserEcho[] intensities"},
    {"sensor_msgs/NavSatStatus", "int8 status;uint16 service"},
    {"sensor_msgs/NavSatFix",
     "std_msgs/Header header;NavSatStatus status;float64 latitude;float64 longitude;float64 altitude;"
     "float64[9] position_covariance;uint8 position_covariance_type"},
    {"sensor_msgs/PointCloud",
     "std_msgs/Header header;geometry_msgs/Point32[] points;ChannelFloat32[] channels"},
    {"sensor_msgs/PointField", "string name;uint32 offset;uint8 datatype;uint32 count"},
    {"sensor_msgs/PointCloud2",
     "std_msgs/Header header;uint32 height;uint32 width;PointField[] fields;bool is_bigendian;uint32 "
     "point_step;"
     "uint32 row_step;uint8[] data;bool is_dense"},
    {"sensor_msgs/Range",
     "std_msgs/Header header;uint8 radiation_type;float32 field_of_view;float32 min_range;float32 max_range;"
     "float32 range;float32 variance"},
    {"sensor_msgs/Range",
     "std_msgs/Header header;uint8 radiation_type;float32 field_of_view;float32 min_range;float32 max_range;"
     "float32 range"},
    {"sensor_msgs/Temperature", "std_msgs/Header header;float64 temperature;float64 variance"},
    {"tf2_msgs/TFMessage", "geometry_msgs/TransformStamped[] transforms"},
    {"visualization_msgs/UVCoordinate", "float32 u;float32 v"},
    {"visualization_msgs/MeshFile", "string filename;uint8[] data"},
    {"visualization_msgs/Marker",
     "std_msgs/Header header;string ns;int32 id;int32 type;int32 action;geometry_msgs/Pose pose;"
     "geometry_msgs/Vector3 scale;std_msgs/ColorRGBA color;builtin_interfaces/Duration lifetime;bool "
     "frame_locked;"
     "geometry_msgs/Point[] points;std_msgs/ColorRGBA[] colors;string texture_resource;"
     "sensor_msgs/CompressedImage texture;UVCoordinate[] uv_coordinates;string text;string mesh_resource;"
     "MeshFile mesh_file;bool mesh_use_embedded_materials"},
    {"visualization_msgs/Marker",
     "std_msgs/Header header;string ns;int32 id;int32 type;int32 action;geometry_msgs/Pose pose;"
     "geometry_msgs/Vector3 scale;std_msgs/ColorRGBA color;builtin_interfaces/Duration lifetime;bool "
     "frame_locked;"
     "geometry_msgs/Point[] points;std_msgs/ColorRGBA[] colors;string text;string mesh_resource;"
     "bool mesh_use_embedded_materials"},
    {"visualization_msgs/MarkerArray", "Marker[] markers"},
    {"nav2_msgs/CostmapMetaData",
     "builtin_interfaces/Time map_load_time;builtin_interfaces/Time update_time;string layer;float32 "
     "resolution;"
     "uint32 size_x;uint32 size_y;geometry_msgs/Pose origin"},
    {"nav2_msgs/Costmap", "std_msgs/Header header;CostmapMetaData metadata;uint8[] data"},
    {"nav2_msgs/Particle", "geometry_msgs/Pose pose;float64 weight"},
    {"nav2_msgs/ParticleCloud", "std_msgs/Header header;Particle[] particles"},
    {"diagnostic_msgs/KeyValue", "string key;string value"},
    {"diagnostic_msgs/DiagnosticStatus",
     "byte level;string name;string message;string hardware_id;KeyValue[] values"},
    {"diagnostic_msgs/DiagnosticArray", "std_msgs/Header header;DiagnosticStatus[] status"},
    {"rosgraph_msgs/Clock", "builtin_interfaces/Time clock"},
    {"rcl_interfaces/Log",
     "builtin_interfaces/Time stamp;uint8 level;string name;string msg;string file;string function;uint32 "
     "line"},
};

/// "nav_msgs/msg/Path" is "nav_msgs/Path".
std::string plainType(std::string_view type) {
  const std::size_t middle = type.find("/msg/");
  if (middle == std::string_view::npos) return std::string(type);
  return std::string(type.substr(0, middle)) + std::string(type.substr(middle + 4));
}

std::vector<const KnownType*> formsOf(std::string_view name) {
  std::vector<const KnownType*> forms;
  for (const KnownType& type : kTypes) {
    if (type.name == name) forms.push_back(&type);
  }
  return forms;
}

/// Appends the fields of a type and, once each, the types in it. `old`: the last form of each type.
void append(const KnownType& type, bool old, std::string& text, std::set<std::string_view>& held,
            std::vector<const KnownType*>& due) {
  std::string_view fields = type.fields;
  while (!fields.empty()) {
    const std::size_t end = fields.find(';');
    const std::string_view field = fields.substr(0, end);
    fields = end == std::string_view::npos ? std::string_view() : fields.substr(end + 1);
    text.append(field).push_back('\n');
    std::string name(field.substr(0, field.find_first_of(" [")));
    if (name.find('/') == std::string::npos)
      name = std::string(type.name.substr(0, type.name.find('/') + 1)) + name;
    const std::vector<const KnownType*> forms = formsOf(name);
    if (forms.empty()) continue;  // built in
    const KnownType* const form = old ? forms.back() : forms.front();
    if (held.insert(form->name).second) due.push_back(form);
  }
}

std::string definitionOf(const KnownType& type, bool old) {
  std::string text;
  std::set<std::string_view> held{type.name};
  std::vector<const KnownType*> due;
  append(type, old, text, held, due);
  for (std::size_t i = 0; i < due.size(); ++i) {
    const KnownType& next = *due[i];
    text += std::string(80, '=') + "\nMSG: " + std::string(next.name) + '\n';
    append(next, old, text, held, due);
  }
  return text;
}

}  // namespace

std::vector<std::string> knownDefinitions(std::string_view type) {
  std::vector<std::string> all;
  const std::vector<const KnownType*> forms = formsOf(plainType(type));
  if (forms.empty()) return all;
  all.push_back(definitionOf(*forms.front(), false));
  std::string older = definitionOf(*forms.back(), true);
  if (older != all.front()) all.push_back(std::move(older));
  return all;
}

bool fitsDefinition(const std::string& type, const std::string& definition,
                    std::span<const std::uint8_t> message) {
  constexpr std::size_t kMostPadding = 3;
  const auto schema = parseRosSchema(type, definition, RosDialect::Ros2);
  if (!schema) return false;
  std::size_t left = 0;
  return rosToCbor(*schema, RosWire::Cdr, message, &left) && left <= kMostPadding;
}

}  // namespace mapwright::recording
