#include "robot/axbot/parse_topics.h"

#include <cmath>
#include <limits>

#include <simdjson.h>

#include "robot/axbot/repair_json.h"

namespace mapwright::robot::axbot {
namespace {

using simdjson::dom::element;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A number; `missing` when the member is absent, NaN when it is there but is not a number.
double number(const element& object, std::string_view name, double missing) {
  element value;
  if (object[name].get(value)) return missing;
  double result = kNaN;
  return value.get(result) ? kNaN : result;
}

std::optional<std::int32_t> integer(const element& object, std::string_view name) {
  const double value = number(object, name, kNaN);
  if (!(std::abs(value) <= double(std::numeric_limits<std::int32_t>::max())) || value != std::floor(value)) {
    return std::nullopt;
  }
  return std::int32_t(value);
}

bool flag(const element& object, std::string_view name) {
  bool value = false;
  if (object[name].get(value)) value = number(object, name, 0) > 0;
  return value;
}

std::string text(const element& object, std::string_view name) {
  element member;
  if (object[name].get(member)) return {};
  std::string_view value;
  if (member.get(value)) return member.is_null() ? std::string() : simdjson::minify(member);
  return std::string(value);
}

std::optional<Eigen::Vector2d> point(const element& value) {
  simdjson::dom::array pair;
  double x = kNaN, y = kNaN;
  if (value.get(pair) || pair.size() < 2 || pair.at(0).get(x) || pair.at(1).get(y)) return std::nullopt;
  if (!std::isfinite(x) || !std::isfinite(y)) return std::nullopt;
  return Eigen::Vector2d(x, y);
}

/// The pose of a list entry. What is missing altogether is harmless (z, or a quaternion that was left out);
/// what is there and is no number spoils the pose.
geometry::Pose3 entryPose(const element& entry) {
  element pose;
  if (entry["pose"].get(pose)) return {kNaN, kNaN, 0, 0, 0, 0, 0};
  element any;
  if (pose["qw"].get(any) && pose["qx"].get(any) && pose["qy"].get(any) && pose["qz"].get(any)) {
    element pos;
    if (!pose["pos"].get(pos)) {
      const auto xy = point(pos);
      return xy ? geometry::poseFromYaw(xy->x(), xy->y(), number(pose, "ori", 0))
                : geometry::Pose3{kNaN, kNaN};
    }
    return {number(pose, "x", kNaN), number(pose, "y", kNaN), number(pose, "z", 0), 0, 0, 0, 1};
  }
  return {number(pose, "x", 0),  number(pose, "y", 0),  number(pose, "z", 0), number(pose, "qx", 0),
          number(pose, "qy", 0), number(pose, "qz", 0), number(pose, "qw", 0)};
}

map::SlamState slamState(const element& message) {
  const std::string state = text(message, "slam_state");
  if (state == "slam" || state == "SLAM_STATE_SLAM" || state == "1") return map::SlamState::Slam;
  if (state == "positioning" || state == "SLAM_STATE_POSITIONING" || state == "2")
    return map::SlamState::Positioning;
  return map::SlamState::Invalid;
}

map::TopicMessage parseSubmapList(const element& message) {
  map::SubmapList list;
  list.slam_state = slamState(message);
  list.uuid = text(message, "uuid");
  simdjson::dom::array rows;
  element member;
  if (message["submap"].get(member) && message["submaps"].get(member)) return list;
  if (member.is_null()) return list;
  if (member.get(rows)) return map::UnreadableMessage{"/submap_list", "Its \"submap\" member is not a list."};
  list.entries.reserve(rows.size());
  std::size_t position = 0;
  for (const element row : rows) {
    ++position;
    const auto trajectory = integer(row, "trajectory_id"), index = integer(row, "submap_index");
    const auto version = integer(row, "submap_version");
    if (!trajectory || !index || !version) {
      list.rejected.push_back("Row " + std::to_string(position) +
                              " has no usable trajectory_id, submap_index or submap_version. Left out.");
      continue;
    }
    list.entries.push_back({{*trajectory, *index},
                            *version,
                            entryPose(row),
                            flag(row, "is_frozen"),
                            flag(row, "is_incremental_submap"),
                            flag(row, "is_nearby_map")});
  }
  return list;
}

map::TopicMessage parseTrackedPose(const element& message) {
  element pos;
  const auto xy = message["pos"].get(pos) ? std::nullopt : point(pos);
  const double yaw = number(message, "ori", 0);
  if (!xy || !std::isfinite(yaw)) {
    return map::UnreadableMessage{"/tracked_pose",
                                  "The robot's pose holds no usable numbers. It stays where it was."};
  }
  return map::TrackedPose{{xy->x(), xy->y(), yaw}};
}

map::TopicMessage parseRobotModel(const element& message) {
  map::RobotModel model;
  const double width = number(message, "width", 0);
  model.width_m = std::isfinite(width) && width > 0 ? width : 0;
  simdjson::dom::array corners;
  if (!message["footprint"].get(corners)) {
    for (const element corner : corners) {
      if (const auto xy = point(corner)) model.footprint.push_back(*xy);
    }
  }
  if (model.footprint.size() < 3) model.footprint.clear();
  return model;
}

map::TopicMessage parseSlamStatus(const element& message) {
  map::SlamStatus status;
  status.state = text(message, "state");
  bool reliable = false;
  if (!message["reliable"].get(reliable)) status.reliable = reliable;
  return status;
}

std::optional<map::TopicMessage> parseTopic(const std::string& topic, const element& message) {
  if (topic == "/submap_list") return parseSubmapList(message);
  if (topic == "/tracked_pose") return parseTrackedPose(message);
  if (topic == "/robot_model") return parseRobotModel(message);
  if (topic == "/slam/state") return parseSlamStatus(message);
  return std::nullopt;
}

TextFrame readFrame(const element& root) {
  TextFrame frame;
  frame.topic = text(root, "topic");
  if (!frame.topic.empty()) {
    frame.message = parseTopic(frame.topic, root);
    return frame;
  }
  simdjson::dom::array topics;
  if (!root["enabled_topics"].get(topics)) {
    frame.enabled_topics.emplace();
    for (const element topic : topics) {
      std::string_view name;
      if (!topic.get(name)) frame.enabled_topics->emplace_back(name);
    }
    return frame;
  }
  for (const char* member : {"error", "detail", "message"}) {
    if (frame.error.empty()) frame.error = text(root, member);
  }
  return frame;
}

}  // namespace

TextFrame parseTextFrame(std::string_view utf8) {
  simdjson::dom::parser parser;
  element root;
  auto failure = parser.parse(simdjson::padded_string(utf8)).get(root);
  if (failure) failure = parser.parse(simdjson::padded_string(repairNumbers(utf8))).get(root);
  if (!failure && root.is_object()) return readFrame(root);
  TextFrame frame;
  frame.message = map::UnreadableMessage{"(unknown)", "A message of " + std::to_string(utf8.size()) +
                                                          " bytes is not a JSON object. It was left out."};
  return frame;
}

}  // namespace mapwright::robot::axbot
