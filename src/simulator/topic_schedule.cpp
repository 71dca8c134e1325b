#include "simulator/topic_schedule.h"

#include <algorithm>
#include <array>

#include "simulator/simulator.h"

namespace mapwright::simulator {
namespace {

using Seconds = std::chrono::duration<double>;

struct TopicRhythm {
  std::string_view topic;
  double period_s;
};
constexpr std::array<TopicRhythm, 32> kRhythms{{{"/slam/state", 1},
                                                {"/map", 5},
                                                {"/map_v2", 5},
                                                {"/path", 0.5},
                                                {"/local_path", 0.2},
                                                {"/trajectory", 1},
                                                {"/trajectory_node_list", 1},
                                                {"/planning_state", 0.5},
                                                {"/alerts", 1},
                                                {"/battery_state", 1},
                                                {"/detailed_battery_state", 1},
                                                {"/wheel_state", 1},
                                                {"/sensor_manager_state", 5},
                                                {"/nearby_robots", 0.5},
                                                {"/nearby_robot_footprints", 5},
                                                {"/landmarks", 5},
                                                {"/nearby_auto_doors", 1},
                                                {"/detected_pallets", 1},
                                                {"/detected_rack", 0.5},
                                                {"/constraint_list", 2},
                                                {"/vision_detected_objects", 0.5},
                                                {"/global_positioning_state", 5},
                                                {"/collected_barcode", 1},
                                                {"/maps/5cm/1hz", 1},
                                                {"/maps/1cm/1hz", 1},
                                                {"/incremental_map", 5},
                                                {"/incremental_map_v2", 5},
                                                {"/env_match_map", 10},
                                                {"/env_symmetry_map", 10},
                                                {"/semantic_points", 0},
                                                {"/scan_matched_points2", 0},
                                                {"/left_laser_2d/matched", 0}}};  // 0: as often as scans come

constexpr std::array<std::string_view, 22> kLatched{"/submap_list",
                                                    "/robot_model",
                                                    "/slam/state",
                                                    "/map",
                                                    "/map_v2",
                                                    "/map/costmap",
                                                    "/map/costmap_v2",
                                                    "/incremental_map",
                                                    "/incremental_map_v2",
                                                    "/env_match_map",
                                                    "/env_symmetry_map",
                                                    "/map/info",
                                                    "/alerts",
                                                    "/battery_state",
                                                    "/wheel_state",
                                                    "/sensor_manager_state",
                                                    "/planning_state",
                                                    "/path",
                                                    "/landmarks",
                                                    "/nearby_robot_footprints",
                                                    "/nearby_auto_doors",
                                                    "/global_positioning_state"};

}  // namespace

std::vector<PeriodicTopic> periodicTopics(const Options& options, std::chrono::steady_clock::time_point now) {
  const auto every = [](double seconds) {
    return std::chrono::duration_cast<std::chrono::steady_clock::duration>(Seconds(seconds));
  };
  std::vector<PeriodicTopic> topics{{"/tracked_pose", every(1 / options.pose_hz), now}};
  for (const TopicRhythm& rhythm : kRhythms) {
    const double period_s = rhythm.period_s > 0 ? rhythm.period_s : 1 / options.scan_hz;
    topics.push_back({rhythm.topic, every(period_s), now + every(period_s)});
  }
  return topics;
}

bool isLatched(std::string_view topic) {
  return std::find(kLatched.begin(), kLatched.end(), topic) != kLatched.end();
}

bool mayBeLeftOut(std::string_view topic) {
  return topic == "/tracked_pose" || std::any_of(kRhythms.begin(), kRhythms.end(),
                                                 [&](const TopicRhythm& r) { return r.topic == topic; });
}

bool isSlow(std::string_view topic) {
  return topic.starts_with("/map") || topic.starts_with("/incremental_map") || topic.starts_with("/env_") ||
         topic == "/scan_matched_points2" || topic == "/left_laser_2d/matched" || topic == "/semantic_points";
}

const std::vector<std::string_view>& mapTopics() {
  static const std::vector<std::string_view> topics{
      "/map", "/map_v2", "/map/costmap", "/map/costmap_v2", "/env_match_map", "/env_symmetry_map"};
  return topics;
}

bool growsWhileMapping(std::string_view topic) { return topic == "/map" || topic == "/map_v2"; }

std::vector<std::string_view> publishedTopics() {
  std::vector<std::string_view> topics{"/tracked_pose"};
  for (const TopicRhythm& rhythm : kRhythms) topics.push_back(rhythm.topic);
  topics.insert(topics.end(), kLatched.begin(), kLatched.end());
  std::sort(topics.begin(), topics.end());
  topics.erase(std::unique(topics.begin(), topics.end()), topics.end());
  return topics;
}

}  // namespace mapwright::simulator
