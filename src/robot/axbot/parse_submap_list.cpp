#include <cmath>
#include <limits>

#include "robot/axbot/faults.h"
#include "robot/axbot/topic_subjects.h"

namespace mapwright::robot::axbot {
namespace {

using wire::Json;

/// A number; `missing` if the member is absent, NaN if it is not a number.
double number(const Json& object, std::string_view name, double missing) {
  Json value;
  return object[name].get(value) ? missing : wire::asNumber(value).value_or(wire::kNaN);
}

/// The pose of a list entry. Missing members are harmless (z, or an omitted quaternion); invalid ones make
/// the pose invalid.
geometry::Pose3 entryPose(const Json& entry) {
  Json pose;
  if (entry["pose"].get(pose)) return {wire::kNaN, wire::kNaN, 0, 0, 0, 0, 0};
  Json any;
  if (pose["qw"].get(any) && pose["qx"].get(any) && pose["qy"].get(any) && pose["qz"].get(any)) {
    Json pos;
    if (!pose["pos"].get(pos)) {
      const auto xy = wire::asPoint(pos);
      return xy ? geometry::poseFromYaw(xy->x(), xy->y(), number(pose, "ori", 0))
                : geometry::Pose3{wire::kNaN, wire::kNaN};
    }
    return {number(pose, "x", wire::kNaN), number(pose, "y", wire::kNaN), number(pose, "z", 0), 0, 0, 0, 1};
  }
  return {number(pose, "x", 0),  number(pose, "y", 0),  number(pose, "z", 0), number(pose, "qx", 0),
          number(pose, "qy", 0), number(pose, "qz", 0), number(pose, "qw", 0)};
}

map::SlamState slamState(const Json& message) {
  const std::string state = wire::text(message, {"slam_state"});
  if (state == "slam" || state == "SLAM_STATE_SLAM" || state == "1") return map::SlamState::Slam;
  if (state == "positioning" || state == "SLAM_STATE_POSITIONING" || state == "2")
    return map::SlamState::Positioning;
  return map::SlamState::Invalid;
}

}  // namespace

MaybeMessage readSubmapTopic(const std::string& topic, const Json& message) {
  if (topic != "/submap_list") return std::nullopt;
  map::SubmapList list;
  list.slam_state = slamState(message);
  list.uuid = wire::text(message, {"uuid"});
  const auto member = wire::member(message, {"submap", "submaps"});
  if (!member) return list;
  wire::JsonList rows;
  if (member->get(rows)) return map::UnreadableMessage{topic, {fault::MemberIsNoList, {"submap"}}};
  list.entries.reserve(rows.size());
  std::size_t position = 0;
  for (const Json row : rows) {
    ++position;
    const auto trajectory = wire::smallInteger(row, {"trajectory_id"});
    const auto index = wire::smallInteger(row, {"submap_index"});
    const auto version = wire::smallInteger(row, {"submap_version"});
    if (!trajectory || !index || !version) {
      list.rejected.push_back({fault::RowWithoutNumbers, {std::int64_t(position)}});
      continue;
    }
    list.entries.push_back({{*trajectory, *index},
                            *version,
                            entryPose(row),
                            wire::flag(row, {"is_frozen"}).value_or(false),
                            wire::flag(row, {"is_incremental_submap"}).value_or(false),
                            wire::flag(row, {"is_nearby_map"}).value_or(false)});
  }
  return list;
}

}  // namespace mapwright::robot::axbot
