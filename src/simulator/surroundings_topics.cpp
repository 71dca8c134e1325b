// What the robot tells about what is around it.
#include <array>
#include <cmath>
#include <numbers>

#include "simulator/json_shapes.h"
#include "simulator/json_text.h"
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
  std::string out = openMessage("/nearby_robots") + ",\"robots\":[";
  for (const Other& other : kOthers) {
    if (out.back() != '[') out += ',';
    out += "{\"uid\":";
    appendJsonText(out, other.uid);
    const double ahead = other.ahead_m + (other.has_trend ? kOthersGainMPerS * state.time() : 0);
    out += ",\"pose\":";
    appendPose(out, state.poseAhead(ahead));
    std::vector<Eigen::Vector2d> trend;
    for (int i = 0; other.has_trend && i < 10; ++i) {
      const geometry::Pose2 later = state.poseAhead(ahead + 0.4 * i);
      trend.emplace_back(later.x_m, later.y_m);
    }
    out += ",\"trend\":";
    appendPoints(out, trend);
    if (*other.digest != '\0') {
      out += ",\"footprint_digest\":";
      appendJsonText(out, other.digest);
    }
    out += '}';
  }
  return out + "]}";
}

std::string nearbyFootprints() {
  std::string out =
      openMessage("/nearby_robot_footprints") + R"(,"footprints":[{"digest":"0150acd9","coordinates":)";
  std::vector<Eigen::Vector2d> round;
  for (int i = 0; i < 16; ++i) {
    const double angle = std::numbers::pi * i / 8;
    round.emplace_back(0.28 * std::cos(angle), 0.24 * std::sin(angle));
  }
  appendPoints(out, round);
  out += R"(},{"digest":"7cb254d5","coordinates":)";
  appendPoints(out, cornersOf({0, 0, 0}, 0.9, 0.6));
  return out + "}]}";
}

std::string landmarks(const Drive& way) {
  std::string out = openMessage("/landmarks") + ",\"landmarks\":[";
  for (int i = 0; i < 5; ++i) {
    if (i > 0) out += ',';
    out += "{\"id\":\"landmark_" + std::to_string(i + 1) + "\",\"pos\":";
    appendPoint(out, way.at(way.length_m() * i / 5).apply({0, i % 2 == 0 ? 1.0 : -1.0}));
    // Older firmware does not say whether one is in use.
    if (i < 4) out += i % 2 == 0 ? ",\"in_use\":true" : ",\"in_use\":false";
    out += '}';
  }
  return out + "]}";
}

std::string autoDoors(const RobotState& state, const Drive& way) {
  constexpr std::array<const char*, 3> kNames{"Main door", "Lager <West>", ""};
  std::string out = openMessage("/nearby_auto_doors") + ",\"doors\":[";
  for (int i = 0; i < 3; ++i) {
    const double t = phaseOf(state.time() + 7.0 * i, kDoorCycleS);
    const char* now = t < 8 ? "closed" : t < 10 ? "opening" : t < 18 ? "open" : "closing";
    if (i > 0) out += ',';
    out += "{\"name\":";
    appendJsonText(out, kNames[static_cast<std::size_t>(i)]);
    out += ",\"mac\":\"30:AE:A4:00:11:2" + std::to_string(2 + i) + "\",\"state\":\"";
    out.append(i == 2 ? "unknown" : now).append("\",\"polygon\":");
    appendPoints(out, cornersOf(way.at(way.length_m() * (0.2 + 0.3 * i)), 0.3, 1.5));
    out += '}';
  }
  return out + "]}";
}

std::string pallets(const RobotState& state, const Drive& way) {
  std::string out = openMessage("/detected_pallets") + ",\"pallets\":[";
  const auto add = [&](const char* frame, const char* id, const geometry::Pose2& pose) {
    if (out.back() != '[') out += ',';
    out.append("{\"frame\":\"").append(frame).append("\",\"pallet_id\":\"").append(id).append("\",\"pose\":");
    appendPose(out, pose);
    out += R"(,"size":{"width":1.0,"depth":1.3,"height":0.3,"pocket_width":0.3,"pocket_height":0.2,)"
           R"("pocket_spacing":0.2}})";
  };
  add("map", "P-1", way.at(way.length_m() * 0.1) * geometry::Pose2{0, 1.4, std::numbers::pi / 2});
  add("map", "P-2", way.at(way.length_m() * 0.1 + 2) * geometry::Pose2{0, 1.4, std::numbers::pi / 2});
  // One is seen for half of the time, and where it is in the robot's frame.
  if (phaseOf(state.time(), 12) < 6) add("base_link", "", {2.0, 0.4, 0.2});
  return out + "]}";
}

std::string rack(const RobotState& state) {
  const double t = phaseOf(state.time(), 30);
  std::string out = openMessage("/detected_rack");
  if (t >= 20) return out + R"(,"rack_detected":false})";
  const bool in_map = t < 10;
  out += R"(,"rack_detected":true,"frame":)";
  out += in_map ? "\"map\"" : "\"base_link\"";
  const geometry::Pose2 place = in_map ? state.poseAhead(2.5) : geometry::Pose2{2.5, 0, 0.1};
  out += ",\"rack_box\":{\"pose\":";
  appendPose(out, place);
  out += R"(,"width":0.64324,"height":0.69234},"rack_box_aligned":{"pose":)";
  appendPose(out, place * geometry::Pose2{0.02, -0.01, -0.03});
  return out + R"(,"width":0.66,"height":0.70}})";
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
  std::string out = openMessage("/constraint_list") + R"(,"Inter residuals, different trajectories":)";
  appendPoints(out, residuals);
  out += R"(,"Inter constraints, different trajectories":)";
  appendPoints(out, links);
  return out + "}";
}

std::string seenObjects(const RobotState& state) {
  std::string out = openMessage("/vision_detected_objects") + ",\"boxes\":[";
  const double sway = std::sin(state.time() / 3);
  const auto add = [&](int label, double value, const geometry::Pose2& pose, const char* dimensions) {
    if (out.back() != '[') out += ',';
    out += "{\"pose\":";
    appendPose(out, pose);
    out.append(",\"dimensions\":").append(dimensions).append(",\"value\":");
    appendJsonFixed(out, value, 3);
    out += ",\"label\":" + std::to_string(label) + "}";
  };
  add(1, 0.8, state.poseAhead(4) * geometry::Pose2{0, 0.6 * sway, 0}, "[0.5,0.4,1.7]");
  add(2, 0.53, state.poseAhead(6) * geometry::Pose2{0, -0.5, 0.3}, "[0.6,1.0,0.9]");
  add(1, 0.42, state.poseAhead(8) * geometry::Pose2{0, 0.3, 0}, "[0.0,0.0,0.0]");
  return out + "]}";
}

std::string globalPositioning(const RobotState& state) {
  std::string out = openMessage("/global_positioning_state");
  const double t = phaseOf(state.time(), 60);
  if (t > 20 && t < 25)
    return out + R"(,"state":"running","score":0,"needs_confirmation":false,"message":""})";
  // The score is a text here, as these robots send it.
  out += R"(,"state":"succeeded","score":"82.1","needs_confirmation":false,"pose":)";
  appendPose(out, state.robotPose());
  return out + R"(,"message":"Succeeded with barcode D2_125"})";
}

std::string barcode(const RobotState& state) {
  std::string out = openMessage("/collected_barcode");
  if (phaseOf(state.time(), 16) < 8) return out + R"(,"state":"no_result"})";
  const geometry::Pose2 relative{1.2, 0.1, std::numbers::pi};
  out += R"(,"state":"ok","barcode":{"id":"D2_125","pose":)";
  appendPose(out, state.robotPose() * relative);
  out += ",\"relative_pose\":";
  appendPose(out, relative);
  return out + "}}";
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
