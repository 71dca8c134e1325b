#include "robot/axbot/stream_topics.h"

namespace mapwright::robot::axbot {

StreamTopics topicsOf(map::Stream stream) {
  using map::Stream;
  switch (stream) {
    case Stream::Pose:
      return {{QStringLiteral("/tracked_pose")}, {}};
    case Stream::Model:
      return {{QStringLiteral("/robot_model")}, {}};
    case Stream::WholeMap:
      return {{QStringLiteral("/map_v2")}, {QStringLiteral("/map")}};
    case Stream::Incremental:
      return {{QStringLiteral("/incremental_map_v2")}, {QStringLiteral("/incremental_map")}};
    case Stream::EnvMatch:
      return {{QStringLiteral("/env_match_map")}, {}};
    case Stream::EnvSymmetry:
      return {{QStringLiteral("/env_symmetry_map")}, {}};
    case Stream::CostmapLow:
      return {{QStringLiteral("/maps/5cm/1hz")}, {}};
    case Stream::CostmapHigh:
      return {{QStringLiteral("/maps/1cm/1hz")}, {}};
    case Stream::MapInfo:
      return {{QStringLiteral("/map/info")}, {}};
    case Stream::Landmarks:
      return {{QStringLiteral("/landmarks")}, {}};
    case Stream::Doors:
      return {{QStringLiteral("/nearby_auto_doors")}, {}};
    case Stream::Pallets:
      return {{QStringLiteral("/detected_pallets")}, {}};
    case Stream::Racks:
      return {{QStringLiteral("/detected_rack")}, {}};
    case Stream::SeenObjects:
      return {{QStringLiteral("/vision_detected_objects")}, {}};
    case Stream::Constraints:
      return {{QStringLiteral("/constraint_list")}, {}};
    case Stream::Trajectory:
      return {{QStringLiteral("/trajectory"), QStringLiteral("/trajectory_node_list")}, {}};
    case Stream::Path:
      return {{QStringLiteral("/path")}, {}};
    case Stream::LocalPath:
      return {{QStringLiteral("/local_path")}, {}};
    case Stream::Planning:
      return {{QStringLiteral("/planning_state")}, {}};
    case Stream::Cloud:
      return {{QStringLiteral("/scan_matched_points2")}, {}};
    case Stream::NearbyRobots:
      return {{QStringLiteral("/nearby_robots")}, {}};
    case Stream::NearbyFootprints:
      return {{QStringLiteral("/nearby_robot_footprints")}, {}};
    case Stream::Battery:
      return {{QStringLiteral("/battery_state")}, {}};
    case Stream::Wheels:
      return {{QStringLiteral("/wheel_state")}, {}};
    case Stream::Alerts:
      return {{QStringLiteral("/alerts")}, {}};
    case Stream::Sensors:
      return {{QStringLiteral("/sensor_manager_state")}, {}};
    case Stream::GlobalPositioning:
      return {{QStringLiteral("/global_positioning_state")}, {}};
  }
  return {};
}

}  // namespace mapwright::robot::axbot
