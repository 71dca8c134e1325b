#include "simulator/axbot_topics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "simulator/value.h"

namespace mapwright::simulator {

/// What a message is made from. Some need the current map, some the way that the robot goes round.
struct Live {
  std::string_view topic;
  const RobotState& state;
  const StoredMap* map;
  const Drive* round;
};

namespace {

constexpr double kPathStepM = 0.25, kLocalPathM = 3, kTrailM = 60, kOwnTrailStepM = 0.5;
constexpr double kArrivedM = 0.8;
constexpr double kOthersGainMPerS = 0.25;  // how much faster than this robot the others drive
constexpr double kDoorCycleS = 20;
constexpr double kWorkDayS = 3600;   // a day's work and a charge, in an hour
constexpr double kWorkShare = 0.85;  // of it at work
constexpr double kFull = 0.81, kSpent = 0.15;
constexpr double kWheelsS =
    120;  // the operator's round: remote from 80 s, by hand from 100 s, stopped from 110 s
constexpr double kLowBattery = 0.2;  // below it, the robot warns

/// How the robot is: what its battery, its wheels and its alerts tell, so that they agree.
struct Vitals {
  double battery = 1;  // 0..1
  bool charging = false;
  std::string control_mode;  // auto, remote, manual
  bool emergency_stop = false;
  bool positioned = true;
};

/// The remainder that is never negative: recordings reach back before the robot's world began.
double phaseOf(double value, double period) { return value - period * std::floor(value / period); }

Vitals vitalsOf(const RobotState& state) {
  Vitals vitals;
  const double day = phaseOf(state.time(), kWorkDayS) / kWorkDayS;
  vitals.charging = day > kWorkShare;
  vitals.battery = vitals.charging ? kSpent + (kFull - kSpent) * (day - kWorkShare) / (1 - kWorkShare)
                                   : kFull - (kFull - kSpent) * day / kWorkShare;
  const double wheels = phaseOf(state.time(), kWheelsS);
  const Controls controls = state.controls();
  vitals.control_mode = controls.control_mode.value_or(wheels < 80    ? "auto"
                                                       : wheels < 100 ? "remote"
                                                                      : "manual");
  vitals.emergency_stop = controls.emergency_stop.value_or(wheels >= 110);
  vitals.positioned = state.isPositioned();
  return vitals;
}

std::vector<Eigen::Vector2d> wayOf(const RobotState& state, double from_m, double to_m, double step_m) {
  std::vector<Eigen::Vector2d> points;
  for (double s = from_m; s < to_m; s += step_m) points.push_back(state.poseAhead(s).apply({0, 0}));
  return points;
}

Value::Object path(const Live& live) {
  const double remaining = live.state.metresToGoal();
  std::vector<Eigen::Vector2d> points = wayOf(live.state, 0, remaining, kPathStepM);
  points.push_back(live.state.poseAhead(remaining).apply({0, 0}));
  return Value::Object(
      {{"stamp", fixed(1000 * stampOf(live.state.time()), 0)}, {"positions", pointsOf(points)}});
}

Value::Object localPath(const Live& live) {
  const double reach = std::min(kLocalPathM, live.state.metresToGoal());
  Value::List poses;
  for (double s = 0; s <= reach; s += kPathStepM) {
    const geometry::Pose2 pose = live.state.poseAhead(s);
    poses.push_back(Value::List{fixed(pose.x_m, 3), fixed(pose.y_m, 3), fixed(pose.yaw_rad, 3)});
  }
  return Value::Object{{"width", 1.1}, {"color", "#FFEACD50"}, {"poses", std::move(poses)}};
}

/// The trail is trimmed once in a while, as robots do it; it is oldest first.
Value::Object trajectory(const Live& live) {
  const double length = std::min(kTrailM, live.state.drivenMetres() + 4);
  std::vector<Eigen::Vector2d> points = wayOf(live.state, -length, 0, kOwnTrailStepM);
  points.push_back(live.state.robotPose().apply({0, 0}));
  return Value::Object{{"points", pointsOf(points)}};
}

Value::Object planningState(const Live& live) {
  const double driven = live.state.drivenMetres(), remaining = live.state.metresToGoal();
  const auto action = static_cast<long long>(std::floor(driven / kGoalM));
  const bool arrived = remaining < kArrivedM;
  const Value target = placeOf(live.state.poseAhead(remaining));
  // Now and then somebody stands in the way.
  const bool stuck = phaseOf(driven, 3 * kGoalM) > 2.9 * kGoalM;
  return Value::Object{{"map_uid", live.map->uid},
                       {"action_id", 3354 + action},
                       {"action_type", action % 3 == 2 ? "along_given_route" : "standard"},
                       {"move_state", arrived ? "succeeded" : "moving"},
                       {"fail_reason", 0},
                       {"fail_reason_str", "none"},
                       {"remaining_distance", fixed(arrived ? 0 : remaining, 3)},
                       {"target_poses", Value::List{target}},
                       {"move_intent", ""},
                       {"intent_target_pose", target},
                       {"stuck_state", stuck ? "move_stucked" : ""}};
}

/// Those that follow from how the robot is, and some that come and go within 40 s.
Value::Object alerts(const Live& live) {
  const double t = phaseOf(live.state.time(), 40);
  const Vitals vitals = vitalsOf(live.state);
  Value::List list;
  const auto add = [&](bool now, int code, const char* level, const char* msg) {
    if (now) list.push_back(Value::Object{{"code", code}, {"level", level}, {"msg", msg}});
  };
  add(vitals.battery < kLowBattery && !vitals.charging, 8501, "warning", "Battery is low (<20%).");
  add(!vitals.positioned, 7002, "error", "Positioning quality is not reliable!");
  add(t >= 10 && t < 25, 6505, "warning", "CPU usage is higher than 80%.");
  add(t >= 15 && t < 35, 6004, "error", "Kernel temperature is higher than 80!");
  add(t >= 32 && t < 38, 11001, "none", "Relocated near <b>Rack 3</b> 🏭");
  return Value::Object{{"alerts", std::move(list)}};
}

Value::Object battery(const Live& live) {
  const Vitals vitals = vitalsOf(live.state);
  Value::Object members{{"secs", fixed(std::floor(stampOf(live.state.time())), 0)},
                        {"voltage", fixed(22 + 5 * vitals.battery, 1)},
                        {"current", fixed(vitals.charging ? -6.2 : 3.6, 1)},
                        {"percentage", fixed(vitals.battery, 3)},
                        {"power_supply_status", vitals.charging ? "charging" : "discharging"}};
  if (live.topic == "/detailed_battery_state") {
    members.emplace_back("capacity", "nan");
    members.emplace_back("design_capacity", 30);
    members.emplace_back("state_of_health", 0.97);
    members.emplace_back("cell_voltages", Value::Float64s{4.141, 4.138, 4.139, 4.133, 4.136, 4.138, 4.138});
  }
  return members;
}

Value::Object wheels(const Live& live) {
  const Vitals vitals = vitalsOf(live.state);
  return Value::Object{{"control_mode", vitals.control_mode},
                       {"emergency_stop_pressed", vitals.emergency_stop},
                       {"wheels_released", false}};
}

Value::Object trackedPose(const Live& live) {
  const geometry::Pose2 pose = live.state.robotPose();
  return Value::Object(
      {{"pos", Value::List{fixed(pose.x_m, 4), fixed(pose.y_m, 4)}}, {"ori", fixed(pose.yaw_rad, 4)}});
}

Value::Object slamState(const Live& live) {
  const bool reliable = live.state.isPositioned();
  return Value::Object{{"state", nameOf(live.state.slamState())},
                       {"reliable", reliable},
                       {"position_quality", reliable ? 10 : 1},
                       {"lidar_matching_score", reliable ? 0.87 : 0.19},
                       {"lidar_matched", reliable}};
}

Value::Object robotModel(const Live&) {
  return Value::Object(
      {{"footprint", Value::Json{"[[0.3,-0.2],[0.35,-0.12],[0.35,0.12],[0.3,0.2],[-0.25,0.27],[-0.32,0.2],"
                                 "[-0.32,-0.2],[-0.25,-0.27]]"}},
       {"expanded_footprint",
        Value::Json{"[[0.35,-0.25],[0.4,-0.13],[0.4,0.13],[0.35,0.25],[-0.28,0.32],[-0.37,0.23],"
                    "[-0.37,-0.23],[-0.28,-0.32]]"}},
       {"width", 0.54}});
}

Value::Object sensors(const Live&) { return Value::Object{{"power_state", "awake"}}; }

Value::Object mapInfo(const Live& live) {
  const bool has_overlays = live.map->overlays && !live.map->overlays->empty();
  return Value::Object{{"name", live.map->name},
                       {"uid", live.map->uid},
                       {"map_version", live.map->map_version},
                       {"overlays_version", live.map->overlays_version},
                       {"overlays", Value::Json{has_overlays ? *live.map->overlays : noOverlays()}}};
}

Value::Object nearbyRobots(const Live& live) {
  struct Other {
    const char *uid, *digest;
    double ahead_m;
    bool has_trend;
  };
  constexpr std::array<Other, 3> kOthers{{{"21922076002353N", "0150acd9", 7, true},
                                          {"21922076002413T", "7cb254d5", -12, true},
                                          {"71822088000017<", "", 31, false}}};
  Value::List robots;
  for (const Other& other : kOthers) {
    const double ahead = other.ahead_m + (other.has_trend ? kOthersGainMPerS * live.state.time() : 0);
    std::vector<Eigen::Vector2d> trend;
    for (int i = 0; other.has_trend && i < 10; ++i)
      trend.push_back(live.state.poseAhead(ahead + 0.4 * i).apply({0, 0}));
    Value robot = Value::Object{
        {"uid", other.uid}, {"pose", placeOf(live.state.poseAhead(ahead))}, {"trend", pointsOf(trend)}};
    if (*other.digest != '\0') robot.set("footprint_digest", other.digest);
    robots.push_back(std::move(robot));
  }
  return Value::Object{{"robots", std::move(robots)}};
}

Value::Object nearbyFootprints(const Live&) {
  std::vector<Eigen::Vector2d> round;
  for (int i = 0; i < 16; ++i) {
    const double angle = std::numbers::pi * i / 8;
    round.emplace_back(0.28 * std::cos(angle), 0.24 * std::sin(angle));
  }
  const Value corners = pointsOf(cornersOf({0, 0, 0}, 0.9, 0.6));
  return Value::Object(
      {{"footprints", Value::List{Value::Object{{"digest", "0150acd9"}, {"coordinates", pointsOf(round)}},
                                  Value::Object{{"digest", "7cb254d5"}, {"coordinates", corners}}}}});
}

Value::Object landmarks(const Live& live) {
  Value::List list;
  for (int i = 0; i < 5; ++i) {
    const auto at = live.round->at(live.round->length_m() * i / 5).apply({0, i % 2 == 0 ? 1.0 : -1.0});
    Value landmark = Value::Object{{"id", "landmark_" + std::to_string(i + 1)}, {"pos", pointOf(at)}};
    // Older firmware does not say whether one is in use.
    if (i < 4) landmark.set("in_use", i % 2 == 0);
    list.push_back(std::move(landmark));
  }
  return Value::Object{{"landmarks", std::move(list)}};
}

Value::Object autoDoors(const Live& live) {
  constexpr std::array<const char*, 3> kNames{"Main door", "Lager <West>", ""};
  Value::List doors;
  for (int i = 0; i < 3; ++i) {
    const double t = phaseOf(live.state.time() + 7.0 * i, kDoorCycleS);
    const char* now = t < 8 ? "closed" : t < 10 ? "opening" : t < 18 ? "open" : "closing";
    const geometry::Pose2 at = live.round->at(live.round->length_m() * (0.2 + 0.3 * i));
    doors.push_back(Value::Object{{"name", kNames[static_cast<std::size_t>(i)]},
                                  {"mac", "30:AE:A4:00:11:2" + std::to_string(2 + i)},
                                  {"state", i == 2 ? "unknown" : now},
                                  {"polygon", pointsOf(cornersOf(at, 0.3, 1.5))}});
  }
  return Value::Object{{"doors", std::move(doors)}};
}

Value::Object pallets(const Live& live) {
  Value::List list;
  const auto add = [&](const char* frame, const char* id, const geometry::Pose2& pose) {
    const Value::Json size{
        R"({"width":1.0,"depth":1.3,"height":0.3,"pocket_width":0.3,"pocket_height":0.2,"pocket_spacing":0.2})"};
    list.push_back(
        Value::Object{{"frame", frame}, {"pallet_id", id}, {"pose", placeOf(pose)}, {"size", size}});
  };
  add("map", "P-1",
      live.round->at(live.round->length_m() * 0.1) * geometry::Pose2{0, 1.4, std::numbers::pi / 2});
  add("map", "P-2",
      live.round->at(live.round->length_m() * 0.1 + 2) * geometry::Pose2{0, 1.4, std::numbers::pi / 2});
  // One is seen for half of the time, and where it is in the robot's frame.
  if (phaseOf(live.state.time(), 12) < 6) add("base_link", "", {2.0, 0.4, 0.2});
  return Value::Object{{"pallets", std::move(list)}};
}

Value::Object rack(const Live& live) {
  const double t = phaseOf(live.state.time(), 30);
  if (t >= 20) return Value::Object{{"rack_detected", false}};
  const bool in_map = t < 10;
  const geometry::Pose2 place = in_map ? live.state.poseAhead(2.5) : geometry::Pose2{2.5, 0, 0.1};
  const Value aligned = placeOf(place * geometry::Pose2{0.02, -0.01, -0.03});
  return Value::Object(
      {{"rack_detected", true},
       {"frame", in_map ? "map" : "base_link"},
       {"rack_box", Value::Object{{"pose", placeOf(place)}, {"width", 0.64324}, {"height", 0.69234}}},
       {"rack_box_aligned",
        Value::Object{{"pose", aligned}, {"width", fixed(0.66, 2)}, {"height", fixed(0.7, 2)}}}});
}

/// Segments as pairs of points, one list by kind.
Value::Object constraints(const Live& live) {
  std::vector<Eigen::Vector2d> residuals, links;
  for (int i = 0; i < 12; ++i) {
    const geometry::Pose2 node = live.state.poseAhead(-2.0 * i);
    residuals.emplace_back(node.apply({0, 0}));
    residuals.emplace_back(node.apply({0.08, i % 2 == 0 ? 0.05 : -0.05}));
    links.emplace_back(node.apply({0, 0}));
    links.emplace_back(live.round->at(live.round->length_m() * i / 12).apply({0, 0}));
  }
  return Value::Object{{"Inter residuals, different trajectories", pointsOf(residuals)},
                       {"Inter constraints, different trajectories", pointsOf(links)}};
}

Value::Object seenObjects(const Live& live) {
  Value::List boxes;
  const double sway = std::sin(live.state.time() / 3);
  const auto add = [&](int label, double value, const geometry::Pose2& pose, const char* dimensions) {
    boxes.push_back(Value::Object{{"pose", placeOf(pose)},
                                  {"dimensions", Value::Json{dimensions}},
                                  {"value", fixed(value, 3)},
                                  {"label", label}});
  };
  add(1, 0.8, live.state.poseAhead(4) * geometry::Pose2{0, 0.6 * sway, 0}, "[0.5,0.4,1.7]");
  add(2, 0.53, live.state.poseAhead(6) * geometry::Pose2{0, -0.5, 0.3}, "[0.6,1.0,0.9]");
  add(1, 0.42, live.state.poseAhead(8) * geometry::Pose2{0, 0.3, 0}, "[0.0,0.0,0.0]");
  return Value::Object{{"boxes", std::move(boxes)}};
}

Value::Object globalPositioning(const Live& live) {
  const std::optional<RobotState::Search> search = live.state.search();
  const double t = phaseOf(live.state.time(), 60);
  if (search ? search->running : t > 20 && t < 25) {
    return Value::Object(
        {{"state", "running"}, {"score", 0}, {"needs_confirmation", false}, {"message", ""}});
  }
  if (search) {
    return Value::Object{{"state", "succeeded"},
                         {"score", 0.78},
                         {"needs_confirmation", search->asks},
                         {"result_source", "lidar"},
                         {"pose", placeOf(search->found)},
                         {"message", "Succeeded with the lidar"}};
  }
  return Value::Object{{"state", "succeeded"},
                       {"score", "82.1"},  // a text here, as these robots send it
                       {"needs_confirmation", false},
                       {"pose", placeOf(live.state.robotPose())},
                       {"message", "Succeeded with barcode D2_125"}};
}

Value::Object barcode(const Live& live) {
  if (phaseOf(live.state.time(), 16) < 8) return Value::Object{{"state", "no_result"}};
  const geometry::Pose2 relative{1.2, 0.1, std::numbers::pi};
  return Value::Object{{"state", "ok"},
                       {"barcode", Value::Object{{"id", "D2_125"},
                                                 {"pose", placeOf(live.state.robotPose() * relative)},
                                                 {"relative_pose", placeOf(relative)}}}};
}

constexpr AxbotTopic kTopics[] = {{"/tracked_pose", kAsPoses, 0, trackedPose},
                                  {"/slam/state", 1, kLatched, slamState},
                                  {"/map", 5, kLatched | kSlow | kOfMap | kGrows},
                                  {"/map_v2", 5, kLatched | kSlow | kOfMap | kGrows},
                                  {"/path", 0.5, kLatched | kNeedsMap, path},
                                  {"/local_path", 0.2, kNeedsMap, localPath},
                                  {"/trajectory", 1, kNeedsMap, trajectory},
                                  {"/trajectory_node_list", 1, kNeedsMap, trajectory},
                                  {"/planning_state", 0.5, kLatched | kNeedsMap, planningState},
                                  {"/alerts", 1, kLatched, alerts},
                                  {"/battery_state", 1, kLatched, battery},
                                  {"/detailed_battery_state", 1, 0, battery},
                                  {"/wheel_state", 1, kLatched, wheels},
                                  {"/sensor_manager_state", 5, kLatched, sensors},
                                  {"/nearby_robots", 0.5, kNeedsRound, nearbyRobots},
                                  {"/nearby_robot_footprints", 5, kLatched | kNeedsRound, nearbyFootprints},
                                  {"/landmarks", 5, kLatched | kNeedsRound, landmarks},
                                  {"/nearby_auto_doors", 1, kLatched | kNeedsRound, autoDoors},
                                  {"/detected_pallets", 1, kNeedsRound, pallets},
                                  {"/detected_rack", 0.5, kNeedsRound, rack},
                                  {"/constraint_list", 2, kNeedsRound, constraints},
                                  {"/vision_detected_objects", 0.5, kNeedsRound, seenObjects},
                                  {"/global_positioning_state", 1, kLatched | kNeedsRound, globalPositioning},
                                  {"/collected_barcode", 1, kNeedsRound, barcode},
                                  {"/maps/5cm/1hz", 1, kSlow},
                                  {"/maps/1cm/1hz", 1, kSlow},
                                  {"/incremental_map", 5, kLatched | kSlow},
                                  {"/incremental_map_v2", 5, kLatched | kSlow},
                                  {"/env_match_map", 10, kLatched | kSlow | kOfMap},
                                  {"/env_symmetry_map", 10, kLatched | kSlow | kOfMap},
                                  {"/semantic_points", kAsScans, kSlow},
                                  {"/scan_matched_points2", kAsScans, kSlow},
                                  {"/left_laser_2d/matched", kAsScans, kSlow},
                                  {kSubmapListTopic, kWhenItChanges, kLatched},
                                  {"/robot_model", kWhenItChanges, kLatched, robotModel},
                                  {"/map/costmap", kWhenItChanges, kLatched | kSlow | kOfMap},
                                  {"/map/costmap_v2", kWhenItChanges, kLatched | kSlow | kOfMap},
                                  {"/map/info", kWhenItChanges, kLatched | kSlow | kNeedsMap, mapInfo}};

}  // namespace

std::span<const AxbotTopic> axbotTopics() { return kTopics; }

const AxbotTopic* axbotTopic(std::string_view name) {
  const std::span<const AxbotTopic> topics = kTopics;
  return byName(topics, name);
}

std::string messageJson(std::string_view topic, Value::Object members) {
  members.emplace(members.begin(), "topic", topic);
  return toJson(members);
}

std::string_view nameOf(map::SlamState state) {
  return state == map::SlamState::Slam          ? "slam"
         : state == map::SlamState::Positioning ? "positioning"
                                                : "invalid";
}

std::optional<std::string> liveMessage(std::string_view topic, const RobotState& state,
                                       const std::optional<StoredMap>& map) {
  const AxbotTopic* const row = axbotTopic(topic);
  if (row == nullptr || row->make == nullptr) return std::nullopt;
  const std::vector<Trajectory>& all = state.scene().trajectories;
  const auto round = std::find_if(
      all.begin(), all.end(), [](const Trajectory& trajectory) { return trajectory.growth == Growth::Live; });
  if ((row->is(kNeedsMap) && !map) || (row->is(kNeedsRound) && round == all.end())) return std::nullopt;
  return messageJson(
      topic, row->make({topic, state, map ? &*map : nullptr, round == all.end() ? nullptr : &round->drive}));
}

}  // namespace mapwright::simulator
