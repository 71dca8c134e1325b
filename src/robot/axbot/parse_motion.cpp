#include <algorithm>
#include <charconv>

#include "robot/axbot/faults.h"
#include "robot/axbot/topic_subjects.h"

namespace mapwright::robot::axbot {
namespace {

using wire::Json;

map::TopicMessage trackedPose(const Json& message) {
  const auto pose = wire::asPose(message);
  Json heading;
  // A missing heading is 0; one that is not a number makes the pose invalid.
  const bool spoilt = !message["ori"].get(heading) && !wire::asNumber(heading);
  if (!pose || spoilt) {
    return map::UnreadableMessage{"/tracked_pose",
                                  Fault(fault::PoseWithoutNumbers).followedBy(Consequence::StaysWhereItWas)};
  }
  return map::TrackedPose{*pose};
}

map::Polyline outline(const Json& message, std::string_view name) {
  map::Polyline corners = wire::polyline(message, {name});
  if (corners.size() < 3) corners.clear();
  return corners;
}

map::TopicMessage robotModel(const Json& message) {
  map::RobotModel model;
  model.width_m = std::max(0.0, wire::number(message, {"width"}).value_or(0));
  model.footprint = outline(message, "footprint");
  model.expanded_footprint = outline(message, "expanded_footprint");
  return model;
}

/// "#RRGGBBAA", "##RRGGBBAA" (as documented), "#RRGGBB".
std::optional<std::uint32_t> colour(std::string_view text) {
  while (text.starts_with('#')) text.remove_prefix(1);
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  if (text.size() == 8) return value;
  return text.size() == 6 ? std::optional((value << 8) | 0xff) : std::nullopt;
}

map::TopicMessage localPath(const Json& message) {
  map::LocalPathMessage path;
  path.width_m = std::max(0.0, wire::number(message, {"width"}).value_or(0));
  path.rgba = colour(wire::text(message, {"color", "colour"}));
  path.points = wire::polyline(message, {"poses", "positions", "points"});
  return path;
}

std::string meaningful(std::string text) { return text == "none" || text == "0" ? std::string() : text; }

map::TopicMessage planningState(const Json& message) {
  map::PlanningState state;
  state.action_id = wire::integer(message, {"action_id"});
  state.action_type = wire::text(message, {"action_type", "move_intent"});
  state.move_state = wire::text(message, {"move_state"});
  state.fail_reason = meaningful(wire::text(message, {"fail_reason_str", "fail_message", "fail_reason"}));
  state.stuck_state = meaningful(wire::text(message, {"stuck_state"}));
  state.remaining_distance_m = wire::number(message, {"remaining_distance"});
  if (const auto targets = wire::list(message, {"target_poses"})) {
    for (const Json target : *targets) {
      if (const auto pose = wire::asPose(target)) state.targets.push_back(*pose);
    }
  }
  return state;
}

map::TopicMessage globalPositioning(const Json& message) {
  map::GlobalPositioning state;
  state.state = wire::text(message, {"state"});
  state.message = wire::text(message, {"message", "msg"});
  state.score = wire::number(message, {"score"});
  state.needs_confirmation = wire::flag(message, {"needs_confirmation"});
  if (const auto pose = wire::member(message, {"pose"})) state.pose = wire::asPose(*pose);
  return state;
}

}  // namespace

MaybeMessage readMotionTopic(const std::string& topic, const Json& message) {
  if (topic == "/tracked_pose") return trackedPose(message);
  if (topic == "/robot_model") return robotModel(message);
  if (topic == "/path") return map::PathMessage{wire::polyline(message, {"positions", "points", "poses"})};
  if (topic == "/local_path") return localPath(message);
  if (topic == "/trajectory" || topic == "/trajectory_node_list") {
    return map::TrajectoryMessage{wire::polyline(message, {"points", "positions"})};
  }
  if (topic == "/planning_state") return planningState(message);
  if (topic == "/global_positioning_state") return globalPositioning(message);
  return std::nullopt;
}

}  // namespace mapwright::robot::axbot
