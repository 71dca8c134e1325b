// What the robot tells about itself.
#include <algorithm>
#include <cmath>

#include "simulator/json_shapes.h"
#include "simulator/json_text.h"
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

void appendStamp(std::string& out, std::string_view key, double value, int digits) {
  out += key;
  appendJsonFixed(out, value, digits);
}

std::string path(const RobotState& state) {
  const double remaining = remainingOf(state.drivenMetres());
  std::vector<Eigen::Vector2d> points;
  for (double s = 0; s < remaining; s += kPathStepM) {
    const geometry::Pose2 pose = state.poseAhead(s);
    points.emplace_back(pose.x_m, pose.y_m);
  }
  const geometry::Pose2 target = state.poseAhead(remaining);
  points.emplace_back(target.x_m, target.y_m);
  std::string out = openMessage("/path");
  appendStamp(out, ",\"stamp\":", 1000 * stampOf(state.time()), 0);
  out += ",\"positions\":";
  appendPoints(out, points);
  return out + "}";
}

std::string localPath(const RobotState& state) {
  std::string out = openMessage("/local_path") + R"(,"width":1.1,"color":"#FFEACD50","poses":[)";
  const double reach = std::min(kLocalPathM, remainingOf(state.drivenMetres()));
  bool first = true;
  for (double s = 0; s <= reach; s += kPathStepM) {
    const geometry::Pose2 pose = state.poseAhead(s);
    out += first ? "[" : ",[";
    first = false;
    appendJsonFixed(out, pose.x_m, 3);
    out += ',';
    appendJsonFixed(out, pose.y_m, 3);
    out += ',';
    appendJsonFixed(out, pose.yaw_rad, 3);
    out += ']';
  }
  return out + "]}";
}

/// The trail is trimmed once in a while, as robots do it; it is oldest first.
std::string trajectory(std::string_view topic, const RobotState& state) {
  const double length = std::min(kTrailM, state.drivenMetres() + 4);
  std::vector<Eigen::Vector2d> points;
  for (double s = -length; s < 0; s += kOwnTrailStepM) {
    const geometry::Pose2 pose = state.poseAhead(s);
    points.emplace_back(pose.x_m, pose.y_m);
  }
  const geometry::Pose2 here = state.robotPose();
  points.emplace_back(here.x_m, here.y_m);
  std::string out = openMessage(topic) + ",\"points\":";
  appendPoints(out, points);
  return out + "}";
}

std::string planningState(const RobotState& state, const StoredMap& map) {
  const double driven = state.drivenMetres(), remaining = remainingOf(driven);
  const auto action = static_cast<long long>(std::floor(driven / kActionM));
  const bool arrived = remaining < kArrivedM;
  std::string out = openMessage("/planning_state") + ",\"map_uid\":";
  appendJsonText(out, map.uid);
  out += ",\"action_id\":" + std::to_string(3354 + action);
  out += action % 3 == 2 ? R"(,"action_type":"along_given_route")" : R"(,"action_type":"standard")";
  out += arrived ? R"(,"move_state":"succeeded")" : R"(,"move_state":"moving")";
  out += R"(,"fail_reason":0,"fail_reason_str":"none","remaining_distance":)";
  appendJsonFixed(out, arrived ? 0 : remaining, 3);
  const geometry::Pose2 target = state.poseAhead(remaining);
  out += ",\"target_poses\":[";
  appendPose(out, target);
  out += R"(],"move_intent":"","intent_target_pose":)";
  appendPose(out, target);
  out += R"(,"stuck_state":")";
  // Now and then somebody stands in the way.
  if (phaseOf(driven, 3 * kActionM) > 2.9 * kActionM) out += "move_stucked";
  return out + "\"}";
}

/// Those that follow from how the robot is, and some that come and go within 40 s.
std::string alerts(const RobotState& state) {
  const double t = phaseOf(state.time(), 40);
  const Vitals vitals = vitalsOf(state);
  std::string list;
  const auto add = [&](bool now, const char* alert) {
    if (!now) return;
    if (!list.empty()) list += ',';
    list += alert;
  };
  add(vitals.battery < kLowBattery && !vitals.charging,
      R"({"code":8501,"level":"warning","msg":"Battery is low (<20%)."})");
  add(!vitals.positioned, R"({"code":7002,"level":"error","msg":"Positioning quality is not reliable!"})");
  add(t >= 10 && t < 25, R"({"code":6505,"level":"warning","msg":"CPU usage is higher than 80%."})");
  add(t >= 15 && t < 35, R"({"code":6004,"level":"error","msg":"Kernel temperature is higher than 80!"})");
  add(t >= 32 && t < 38, R"({"code":11001,"level":"none","msg":"Relocated near <b>Rack 3</b> 🏭"})");
  std::string out = openMessage("/alerts") + ",\"alerts\":[";
  return out + list + "]}";
}

std::string battery(std::string_view topic, const RobotState& state) {
  const Vitals vitals = vitalsOf(state);
  std::string out = openMessage(topic);
  appendStamp(out, ",\"secs\":", std::floor(stampOf(state.time())), 0);
  appendStamp(out, ",\"voltage\":", 22 + 5 * vitals.battery, 1);
  appendStamp(out, ",\"current\":", vitals.charging ? -6.2 : 3.6, 1);
  appendStamp(out, ",\"percentage\":", vitals.battery, 3);
  out += vitals.charging ? R"(,"power_supply_status":"charging")" : R"(,"power_supply_status":"discharging")";
  if (topic == "/detailed_battery_state") {
    out += R"(,"capacity":"nan","design_capacity":30,"state_of_health":0.97,)"
           R"("cell_voltages":[4.141,4.138,4.139,4.133,4.136,4.138,4.138])";
  }
  return out + "}";
}

std::string wheels(const RobotState& state) {
  const Vitals vitals = vitalsOf(state);
  std::string out = openMessage("/wheel_state") + ",\"control_mode\":";
  appendJsonText(out, vitals.control_mode);
  out += vitals.emergency_stop ? ",\"emergency_stop_pressed\":true" : ",\"emergency_stop_pressed\":false";
  return out + R"(,"wheels_released":false})";
}

std::string trackedPose(const geometry::Pose2& pose) {
  std::string out = openMessage("/tracked_pose") + ",\"pos\":[";
  appendJsonFixed(out, pose.x_m, 4);
  out += ',';
  appendJsonFixed(out, pose.y_m, 4);
  out += R"(],"ori":)";
  appendJsonFixed(out, pose.yaw_rad, 4);
  out += '}';
  return out;
}

std::string slamState(const RobotState& state) {
  std::string out = openMessage("/slam/state") + ",\"state\":";
  appendJsonText(out, nameOf(state.slamState()));
  return out +
         (state.isPositioned()
              ? R"(,"reliable":true,"position_quality":10,"lidar_matching_score":0.87,"lidar_matched":true})"
              : R"(,"reliable":false,"position_quality":1,"lidar_matching_score":0.19,"lidar_matched":false})");
}

constexpr std::string_view kRobotModel =
    R"({"topic":"/robot_model","footprint":[[0.3,-0.2],[0.35,-0.12],[0.35,0.12],[0.3,0.2],[-0.25,0.27],[-0.32,0.2],)"
    R"([-0.32,-0.2],[-0.25,-0.27]],"expanded_footprint":[[0.35,-0.25],[0.4,-0.13],[0.4,0.13],[0.35,0.25],)"
    R"([-0.28,0.32],[-0.37,0.23],[-0.37,-0.23],[-0.28,-0.32]],"width":0.54})";

std::string mapInfo(const StoredMap& map) {
  std::string out = openMessage("/map/info") + ",\"name\":";
  appendJsonText(out, map.name);
  out += ",\"uid\":";
  appendJsonText(out, map.uid);
  out += ",\"map_version\":" + std::to_string(map.map_version) +
         ",\"overlays_version\":" + std::to_string(map.overlays_version) + ",\"overlays\":";
  return out + (map.overlays && !map.overlays->empty() ? *map.overlays : noOverlays()) + "}";
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
  if (topic == "/sensor_manager_state") return openMessage(topic) + R"(,"power_state":"awake"})";
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
