#include "simulator/ros/topic_table.h"

#include "simulator/ros/dispatcher.h"

namespace mapwright::simulator::ros {

std::vector<TopicRow> topicTable(const Options& options, const RosFaults& faults) {
  const bool is_ros1 = options.ros.dialect == RosDialect::Ros1;
  constexpr bool kLatched = true, kSlow = true;
  std::vector<TopicRow> rows{
      {"/map", "nav_msgs/OccupancyGrid", 5, kLatched, kSlow},
      {"/map_updates", "map_msgs/OccupancyGridUpdate", 1, false, kSlow},
      {"/global_costmap/costmap", "nav_msgs/OccupancyGrid", 0, kLatched, kSlow},
      {"/global_costmap/costmap_updates", "map_msgs/OccupancyGridUpdate", 1, false, kSlow},
      {"/local_costmap/costmap", "nav_msgs/OccupancyGrid", 0.5, kLatched, kSlow},
      {"/plan", "nav_msgs/Path", 1, kLatched},
      {"/local_plan", "nav_msgs/Path", 0.2},
      {"/scan", "sensor_msgs/LaserScan", 0.1},
      {"/points", "sensor_msgs/PointCloud2", 1 / options.scan_hz, false, kSlow},
      {"/odom", "nav_msgs/Odometry", 0.05},
      {"/amcl_pose", "geometry_msgs/PoseWithCovarianceStamped", 0.5, kLatched},
      {"/tf", "tf2_msgs/TFMessage", 0.02},
      {"/tf_static", "tf2_msgs/TFMessage", 0, kLatched},
      {is_ros1 ? "/move_base/local_costmap/footprint" : "/local_costmap/published_footprint",
       "geometry_msgs/PolygonStamped", 0.2},
      {"/markers", "visualization_msgs/MarkerArray", 1, kLatched},
      {"/goal_pose", "geometry_msgs/PoseStamped", 1, kLatched},
      {"/initialpose", "geometry_msgs/PoseWithCovarianceStamped", 0, false, false, true},
      {"/cmd_vel", "geometry_msgs/Twist", 0, false, false, true}};
  if (options.ros.kabam) {
    rows.push_back({kMapInfoTopic, "kabam_msgs/MapInfo", 0, kLatched});
    rows.push_back({kMapListTopic, "kabam_msgs/MapList", 0, kLatched});
    rows.push_back({kArchivedListTopic, "kabam_msgs/MapList", 0, kLatched});
    rows.push_back({kWaypointsTopic, "kabam_msgs/MapWaypointList", 0, kLatched});
  }
  const DispatcherOptions& dispatcher = options.ros.dispatcher;
  if (dispatcher.there) {
    std::erase_if(rows, [](const TopicRow& row) { return row.name == "/map" || row.name == "/map_updates"; });
    if (dispatcher.planar) rows.push_back({"/map_metadata", "nav_msgs/MapMetaData", 0, kLatched});
    for (const std::string_view name : Dispatcher::projectedTopics()) {
      if (dispatcher.spatial) rows.push_back({name, "map_msgs/ProjectedMap", 0, kLatched, kSlow});
    }
  }
  for (TopicRow& row : rows) {
    if (faults.wrong_type && hasOddType(row.name)) row.type = "std_msgs/String";
  }
  return rows;
}

}  // namespace mapwright::simulator::ros
