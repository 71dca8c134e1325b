// What the robot tells about itself.
#include <algorithm>
#include <cmath>

#include "simulator/json_shapes.h"
#include "simulator/live_topics.h"
#include "simulator/map_overlays.h"
#include "simulator/stamp.h"
#include "simulator/vitals.h"

namespace mapwright::simulator {
namespace {

constexpr double kActionM = 40;  // one move action after the other, each so long
constexpr double kPathStepM = 0.25, kLocalPathM = 3, kTrailM = 60, kOwnTrailStepM = 0.5;
constexpr double kArrivedM = 0.8;

/// Metres to the current action's target.
double remainingOf(double driven_m) { return kActionM - phaseOf(driven_m, kActionM); }

std::vector<Eigen::Vector2d> wayOf(const RobotState& state, double from_m, double to_m, double step_m) {
  std::vector<Eigen::Vector2d> points;
  for (double s = from_m; s < to_m; s += step_m) points.push_back(state.poseAhead(s).apply({0, 0}));
  return points;
}

std::string path(const RobotState& state) {
  const double remaining = remainingOf(state.drivenMetres());
  std::vector<Eigen::Vector2d> points = wayOf(state, 0, remaining, kPathStepM);
  points.push_back(state.poseAhead(remaining).apply({0, 0}));
  return messageJson("/path",
                     {{"stamp", fixed(1000 * stampOf(state.time()), 0)}, {"positions", pointsOf(points)}});
}

std::string localPath(const RobotState& state) {
  const double reach = std::min(kLocalPathM, remainingOf(state.drivenMetres()));
  Value::List poses;
  for (double s = 0; s <= reach; s += kPathStepM) {
    const geometry::Pose2 pose = state.poseAhead(s);
    poses.push_back(Value::List{fixed(pose.x_m, 3), fixed(pose.y_m, 3), fixed(pose.yaw_rad, 3)});
  }
  return messageJson("/local_path", {{"width", 1.1}, {"color", "#FFEACD50"}, {"poses", std::move(poses)}});
}

/// The trail is trimmed once in a while, as robots do it; it is oldest first.
std::string trajectory(std::string_view topic, const RobotState& state) {
  const double length = std::min(kTrailM, state.drivenMetres() + 4);
  std::vector<Eigen::Vector2d> points = wayOf(state, -length, 0, kOwnTrailStepM);
  points.push_back(state.robotPose().apply({0, 0}));
  return messageJson(topic, {{"points", pointsOf(points)}});
}

std::string planningState(const RobotState& state, const StoredMap& map) {
  const double driven = state.drivenMetres(), remaining = remainingOf(driven);
  const auto action = static_cast<long long>(std::floor(driven / kActionM));
  const bool arrived = remaining < kArrivedM;
  const Value target = placeOf(state.poseAhead(remaining));
  // Now and then somebody stands in the way.
  const bool stuck = phaseOf(driven, 3 * kActionM) > 2.9 * kActionM;
  return messageJson("/planning_state", {{"map_uid", map.uid},
                                         {"action_id", 3354 + action},
                                         {"action_type", action % 3 == 2 ? "along_given_route" : "standard"},
                                         {"move_state", arrived ? "succeeded" : "moving"},
                                         {"fail_reason", 0},
                                         {"fail_reason_str", "none"},
                                         {"remaining_distance", fixed(arrived ? 0 : remaining, 3)},
                                         {"target_poses", Value::List{target}},
                                         {"move_intent", ""},
                                         {"intent_target_pose", target},
                                         {"stuck_state", stuck ? "move_stucked" : ""}});
}

/// Those that follow from how the robot is, and some that come and go within 40 s.
std::string alerts(const RobotState& state) {
  const double t = phaseOf(state.time(), 40);
  const Vitals vitals = vitalsOf(state);
  Value::List list;
  const auto add = [&](bool now, int code, const char* level, const char* msg) {
    if (now) list.push_back(Value::Object{{"code", code}, {"level", level}, {"msg", msg}});
  };
  add(vitals.battery < kLowBattery && !vitals.charging, 8501, "warning", "Battery is low (<20%).");
  add(!vitals.positioned, 7002, "error", "Positioning quality is not reliable!");
  add(t >= 10 && t < 25, 6505, "warning", "CPU usage is higher than 80%.");
  add(t >= 15 && t < 35, 6004, "error", "Kernel temperature is higher than 80!");
  add(t >= 32 && t < 38, 11001, "none", "Relocated near <b>Rack 3</b> 🏭");
  return messageJson("/alerts", {{"alerts", std::move(list)}});
}

std::string battery(std::string_view topic, const RobotState& state) {
  const Vitals vitals = vitalsOf(state);
  Value::Object members{{"secs", fixed(std::floor(stampOf(state.time())), 0)},
                        {"voltage", fixed(22 + 5 * vitals.battery, 1)},
                        {"current", fixed(vitals.charging ? -6.2 : 3.6, 1)},
                        {"percentage", fixed(vitals.battery, 3)},
                        {"power_supply_status", vitals.charging ? "charging" : "discharging"}};
  if (topic == "/detailed_battery_state") {
    members.emplace_back("capacity", "nan");
    members.emplace_back("design_capacity", 30);
    members.emplace_back("state_of_health", 0.97);
    members.emplace_back("cell_voltages", Value::Float64s{4.141, 4.138, 4.139, 4.133, 4.136, 4.138, 4.138});
  }
  return messageJson(topic, std::move(members));
}

std::string wheels(const RobotState& state) {
  const Vitals vitals = vitalsOf(state);
  return messageJson("/wheel_state", {{"control_mode", vitals.control_mode},
                                      {"emergency_stop_pressed", vitals.emergency_stop},
                                      {"wheels_released", false}});
}

std::string trackedPose(const geometry::Pose2& pose) {
  return messageJson("/tracked_pose", {{"pos", Value::List{fixed(pose.x_m, 4), fixed(pose.y_m, 4)}},
                                       {"ori", fixed(pose.yaw_rad, 4)}});
}

std::string slamState(const RobotState& state) {
  const bool reliable = state.isPositioned();
  return messageJson("/slam/state", {{"state", nameOf(state.slamState())},
                                     {"reliable", reliable},
                                     {"position_quality", reliable ? 10 : 1},
                                     {"lidar_matching_score", reliable ? 0.87 : 0.19},
                                     {"lidar_matched", reliable}});
}

constexpr std::string_view kRobotModel =
    R"({"topic":"/robot_model","footprint":[[0.3,-0.2],[0.35,-0.12],[0.35,0.12],[0.3,0.2],[-0.25,0.27],[-0.32,0.2],)"
    R"([-0.32,-0.2],[-0.25,-0.27]],"expanded_footprint":[[0.35,-0.25],[0.4,-0.13],[0.4,0.13],[0.35,0.25],)"
    R"([-0.28,0.32],[-0.37,0.23],[-0.37,-0.23],[-0.28,-0.32]],"width":0.54})";

std::string mapInfo(const StoredMap& map) {
  const bool has_overlays = map.overlays && !map.overlays->empty();
  return messageJson("/map/info", {{"name", map.name},
                                   {"uid", map.uid},
                                   {"map_version", map.map_version},
                                   {"overlays_version", map.overlays_version},
                                   {"overlays", Value::Json{has_overlays ? *map.overlays : noOverlays()}}});
}

}  // namespace

std::string_view nameOf(map::SlamState state) {
  switch (state) {
    case map::SlamState::Slam:
      return "slam";
    case map::SlamState::Positioning:
      return "positioning";
    case map::SlamState::Invalid:
      break;
  }
  return "invalid";
}

std::optional<std::string> ownTopic(std::string_view topic, const RobotState& state,
                                    const std::optional<StoredMap>& map) {
  if (topic == "/tracked_pose") return trackedPose(state.robotPose());
  if (topic == "/robot_model") return std::string(kRobotModel);
  if (topic == "/slam/state") return slamState(state);
  if (topic == "/battery_state" || topic == "/detailed_battery_state") return battery(topic, state);
  if (topic == "/wheel_state") return wheels(state);
  if (topic == "/sensor_manager_state") return messageJson(topic, {{"power_state", "awake"}});
  if (topic == "/alerts") return alerts(state);
  if (!map) return std::nullopt;
  if (topic == "/map/info") return mapInfo(*map);
  if (topic == "/path") return path(state);
  if (topic == "/local_path") return localPath(state);
  if (topic == "/trajectory" || topic == "/trajectory_node_list") return trajectory(topic, state);
  if (topic == "/planning_state") return planningState(state, *map);
  return std::nullopt;
}

}  // namespace mapwright::simulator
