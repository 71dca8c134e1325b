// The topics of the simulated ROS robot, with their rates and types.
#pragma once

#include <string_view>
#include <vector>

#include "simulator/simulator.h"

namespace mapwright::simulator::ros {

struct TopicRow {
  std::string_view name, type;  // "nav_msgs/Path", without the word in the middle
  double period_s = 0;          // 0: when it changes
  bool latched = false;         // the last message is sent to who comes later
  bool slow = false;            // takes many milliseconds to make
  bool incoming = false;        // the robot only listens; what is published there reaches all who subscribed
};

/// The rows of this robot.
std::vector<TopicRow> topicTable(const Options& options, const RosFaults& faults);

/// The topics that RosFaults::wrong_type is about.
constexpr bool hasOddType(std::string_view topic) {
  return topic == "/map" || topic == "/scan" || topic == "/odom";
}

/// The topics of the map manager.
inline constexpr std::string_view kMapInfoTopic = "/map_manager/current_map_info";
inline constexpr std::string_view kMapListTopic = "/map_manager/map_list";
inline constexpr std::string_view kArchivedListTopic = "/map_manager/archived_map_list";
inline constexpr std::string_view kWaypointsTopic = "/map_manager/current_map_waypoints";

}  // namespace mapwright::simulator::ros
