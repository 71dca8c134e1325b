#include "robot/axbot/stream_topics.h"

namespace mapwright::robot::axbot {
namespace {

using map::Stream;

struct Row {
  Stream stream;
  const char* topic;
  bool older = false;
};
constexpr Row kRows[] = {
    {Stream::Pose, "/tracked_pose"},
    {Stream::Model, "/robot_model"},
    {Stream::WholeMap, "/map_v2"},
    {Stream::WholeMap, "/map", true},
    {Stream::Incremental, "/incremental_map_v2"},
    {Stream::Incremental, "/incremental_map", true},
    {Stream::EnvMatch, "/env_match_map"},
    {Stream::EnvSymmetry, "/env_symmetry_map"},
    {Stream::CostmapLow, "/maps/5cm/1hz"},
    {Stream::CostmapHigh, "/maps/1cm/1hz"},
    {Stream::MapInfo, "/map/info"},
    {Stream::Landmarks, "/landmarks"},
    {Stream::Doors, "/nearby_auto_doors"},
    {Stream::Pallets, "/detected_pallets"},
    {Stream::Racks, "/detected_rack"},
    {Stream::SeenObjects, "/vision_detected_objects"},
    {Stream::Constraints, "/constraint_list"},
    {Stream::Trajectory, "/trajectory"},
    {Stream::Trajectory, "/trajectory_node_list"},
    {Stream::Path, "/path"},
    {Stream::LocalPath, "/local_path"},
    {Stream::Planning, "/planning_state"},
    {Stream::Cloud, "/scan_matched_points2"},
    {Stream::NearbyRobots, "/nearby_robots"},
    {Stream::NearbyFootprints, "/nearby_robot_footprints"},
    {Stream::Battery, "/battery_state"},
    {Stream::Wheels, "/wheel_state"},
    {Stream::Alerts, "/alerts"},
    {Stream::Sensors, "/sensor_manager_state"},
    {Stream::GlobalPositioning, "/global_positioning_state"},
};

}  // namespace

StreamTopics topicsOf(Stream stream) {
  StreamTopics topics;
  for (const Row& row : kRows) {
    if (row.stream == stream) (row.older ? topics.older : topics.usual) << QLatin1String(row.topic);
  }
  return topics;
}

}  // namespace mapwright::robot::axbot
