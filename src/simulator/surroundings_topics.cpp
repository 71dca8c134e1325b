// What the robot tells about what is around it.
#include <array>
#include <cmath>
#include <numbers>

#include "simulator/json_shapes.h"
#include "simulator/live_topics.h"
#include "simulator/vitals.h"

namespace mapwright::simulator {
namespace {

constexpr double kOthersGainMPerS = 0.25;  // how much faster than this robot the others drive
constexpr double kDoorCycleS = 20;

const Trajectory* roundOf(const Scene& scene) {
  for (const Trajectory& trajectory : scene.trajectories) {
    if (trajectory.growth == Growth::Live) return &trajectory;
  }
  return nullptr;
}

std::string nearbyRobots(const RobotState& state) {
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
    const double ahead = other.ahead_m + (other.has_trend ? kOthersGainMPerS * state.time() : 0);
    std::vector<Eigen::Vector2d> trend;
    for (int i = 0; other.has_trend && i < 10; ++i)
      trend.push_back(state.poseAhead(ahead + 0.4 * i).apply({0, 0}));
    Value robot = Value::Object{
        {"uid", other.uid}, {"pose", placeOf(state.poseAhead(ahead))}, {"trend", pointsOf(trend)}};
    if (*other.digest != '\0') robot.set("footprint_digest", other.digest);
    robots.push_back(std::move(robot));
  }
  return messageJson("/nearby_robots", {{"robots", std::move(robots)}});
}

std::string nearbyFootprints() {
  std::vector<Eigen::Vector2d> round;
  for (int i = 0; i < 16; ++i) {
    const double angle = std::numbers::pi * i / 8;
    round.emplace_back(0.28 * std::cos(angle), 0.24 * std::sin(angle));
  }
  const Value corners = pointsOf(cornersOf({0, 0, 0}, 0.9, 0.6));
  return messageJson(
      "/nearby_robot_footprints",
      {{"footprints", Value::List{Value::Object{{"digest", "0150acd9"}, {"coordinates", pointsOf(round)}},
                                  Value::Object{{"digest", "7cb254d5"}, {"coordinates", corners}}}}});
}

std::string landmarks(const Drive& way) {
  Value::List list;
  for (int i = 0; i < 5; ++i) {
    const auto at = way.at(way.length_m() * i / 5).apply({0, i % 2 == 0 ? 1.0 : -1.0});
    Value landmark = Value::Object{{"id", "landmark_" + std::to_string(i + 1)}, {"pos", pointOf(at)}};
    // Older firmware does not say whether one is in use.
    if (i < 4) landmark.set("in_use", i % 2 == 0);
    list.push_back(std::move(landmark));
  }
  return messageJson("/landmarks", {{"landmarks", std::move(list)}});
}

std::string autoDoors(const RobotState& state, const Drive& way) {
  constexpr std::array<const char*, 3> kNames{"Main door", "Lager <West>", ""};
  Value::List doors;
  for (int i = 0; i < 3; ++i) {
    const double t = phaseOf(state.time() + 7.0 * i, kDoorCycleS);
    const char* now = t < 8 ? "closed" : t < 10 ? "opening" : t < 18 ? "open" : "closing";
    const geometry::Pose2 at = way.at(way.length_m() * (0.2 + 0.3 * i));
    doors.push_back(Value::Object{{"name", kNames[static_cast<std::size_t>(i)]},
                                  {"mac", "30:AE:A4:00:11:2" + std::to_string(2 + i)},
                                  {"state", i == 2 ? "unknown" : now},
                                  {"polygon", pointsOf(cornersOf(at, 0.3, 1.5))}});
  }
  return messageJson("/nearby_auto_doors", {{"doors", std::move(doors)}});
}

std::string pallets(const RobotState& state, const Drive& way) {
  Value::List list;
  const auto add = [&](const char* frame, const char* id, const geometry::Pose2& pose) {
    const Value::Json size{
        R"({"width":1.0,"depth":1.3,"height":0.3,"pocket_width":0.3,"pocket_height":0.2,"pocket_spacing":0.2})"};
    list.push_back(
        Value::Object{{"frame", frame}, {"pallet_id", id}, {"pose", placeOf(pose)}, {"size", size}});
  };
  add("map", "P-1", way.at(way.length_m() * 0.1) * geometry::Pose2{0, 1.4, std::numbers::pi / 2});
  add("map", "P-2", way.at(way.length_m() * 0.1 + 2) * geometry::Pose2{0, 1.4, std::numbers::pi / 2});
  // One is seen for half of the time, and where it is in the robot's frame.
  if (phaseOf(state.time(), 12) < 6) add("base_link", "", {2.0, 0.4, 0.2});
  return messageJson("/detected_pallets", {{"pallets", std::move(list)}});
}

std::string rack(const RobotState& state) {
  const double t = phaseOf(state.time(), 30);
  if (t >= 20) return messageJson("/detected_rack", {{"rack_detected", false}});
  const bool in_map = t < 10;
  const geometry::Pose2 place = in_map ? state.poseAhead(2.5) : geometry::Pose2{2.5, 0, 0.1};
  const Value aligned = placeOf(place * geometry::Pose2{0.02, -0.01, -0.03});
  return messageJson(
      "/detected_rack",
      {{"rack_detected", true},
       {"frame", in_map ? "map" : "base_link"},
       {"rack_box", Value::Object{{"pose", placeOf(place)}, {"width", 0.64324}, {"height", 0.69234}}},
       {"rack_box_aligned",
        Value::Object{{"pose", aligned}, {"width", fixed(0.66, 2)}, {"height", fixed(0.7, 2)}}}});
}

/// Segments as pairs of points, one list by kind.
std::string constraints(const RobotState& state, const Drive& way) {
  std::vector<Eigen::Vector2d> residuals, links;
  for (int i = 0; i < 12; ++i) {
    const geometry::Pose2 node = state.poseAhead(-2.0 * i);
    residuals.emplace_back(node.apply({0, 0}));
    residuals.emplace_back(node.apply({0.08, i % 2 == 0 ? 0.05 : -0.05}));
    links.emplace_back(node.apply({0, 0}));
    links.emplace_back(way.at(way.length_m() * i / 12).apply({0, 0}));
  }
  return messageJson("/constraint_list", {{"Inter residuals, different trajectories", pointsOf(residuals)},
                                          {"Inter constraints, different trajectories", pointsOf(links)}});
}

std::string seenObjects(const RobotState& state) {
  Value::List boxes;
  const double sway = std::sin(state.time() / 3);
  const auto add = [&](int label, double value, const geometry::Pose2& pose, const char* dimensions) {
    boxes.push_back(Value::Object{{"pose", placeOf(pose)},
                                  {"dimensions", Value::Json{dimensions}},
                                  {"value", fixed(value, 3)},
                                  {"label", label}});
  };
  add(1, 0.8, state.poseAhead(4) * geometry::Pose2{0, 0.6 * sway, 0}, "[0.5,0.4,1.7]");
  add(2, 0.53, state.poseAhead(6) * geometry::Pose2{0, -0.5, 0.3}, "[0.6,1.0,0.9]");
  add(1, 0.42, state.poseAhead(8) * geometry::Pose2{0, 0.3, 0}, "[0.0,0.0,0.0]");
  return messageJson("/vision_detected_objects", {{"boxes", std::move(boxes)}});
}

std::string globalPositioning(const RobotState& state) {
  const double t = phaseOf(state.time(), 60);
  const char* const topic = "/global_positioning_state";
  if (t > 20 && t < 25) {
    return messageJson(topic,
                       {{"state", "running"}, {"score", 0}, {"needs_confirmation", false}, {"message", ""}});
  }
  return messageJson(topic, {{"state", "succeeded"},
                             {"score", "82.1"},  // a text here, as these robots send it
                             {"needs_confirmation", false},
                             {"pose", placeOf(state.robotPose())},
                             {"message", "Succeeded with barcode D2_125"}});
}

std::string barcode(const RobotState& state) {
  if (phaseOf(state.time(), 16) < 8) return messageJson("/collected_barcode", {{"state", "no_result"}});
  const geometry::Pose2 relative{1.2, 0.1, std::numbers::pi};
  return messageJson("/collected_barcode",
                     {{"state", "ok"},
                      {"barcode", Value::Object{{"id", "D2_125"},
                                                {"pose", placeOf(state.robotPose() * relative)},
                                                {"relative_pose", placeOf(relative)}}}});
}

}  // namespace

std::optional<std::string> surroundingsTopic(std::string_view topic, const RobotState& state) {
  const Trajectory* round = roundOf(state.scene());
  if (round == nullptr) return std::nullopt;
  if (topic == "/nearby_robots") return nearbyRobots(state);
  if (topic == "/nearby_robot_footprints") return nearbyFootprints();
  if (topic == "/landmarks") return landmarks(round->drive);
  if (topic == "/nearby_auto_doors") return autoDoors(state, round->drive);
  if (topic == "/detected_pallets") return pallets(state, round->drive);
  if (topic == "/detected_rack") return rack(state);
  if (topic == "/constraint_list") return constraints(state, round->drive);
  if (topic == "/vision_detected_objects") return seenObjects(state);
  if (topic == "/global_positioning_state") return globalPositioning(state);
  if (topic == "/collected_barcode") return barcode(state);
  return std::nullopt;
}

}  // namespace mapwright::simulator
