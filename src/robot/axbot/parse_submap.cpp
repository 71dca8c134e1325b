#include "robot/axbot/parse_submap.h"

#include "robot/axbot/faults.h"

namespace mapwright::robot::axbot {
namespace {

geometry::Pose3 toPose(const ros_messages::Pose& pose) {
  return {pose.x(), pose.y(), pose.z(), pose.qx(), pose.qy(), pose.qz(), pose.qw()};
}

std::string codeName(int code) {
  const std::string& name = ros_messages::slam::StatusCode_Name(ros_messages::slam::StatusCode(code));
  return name.empty() ? "code " + std::to_string(code) : name;
}

}  // namespace

map::SubmapAnswer parseSubmapResponse(const map::SubmapKey& key, std::string_view body) {
  using Outcome = map::SubmapAnswer::Outcome;
  map::SubmapAnswer answer;
  answer.key = key;
  answer.bytes = body.size();
  ros_messages::slam::SubmapQueryV2Response response;
  if (body.empty()) {
    answer.reason = fault::EmptyAnswer;
    return answer;
  }
  if (body.size() > std::size_t(std::numeric_limits<int>::max()) ||
      !response.ParseFromArray(body.data(), int(body.size()))) {
    answer.reason = {fault::AnswerIsNoSubmap, {std::int64_t(body.size())}};
    return answer;
  }
  answer.version = response.submap_version();
  const int code = response.status().code();
  if (code != ros_messages::slam::OK) {
    answer.outcome = code == ros_messages::slam::NOT_FOUND       ? Outcome::NotFound
                     : code == ros_messages::slam::UUID_MISMATCH ? Outcome::WrongUuid
                                                                 : Outcome::Failed;
    answer.reason = {
        fault::RobotAnswered, {codeName(code)}, {fault::said(response.status().message().substr(0, 300))}};
    return answer;
  }
  answer.outcome = Outcome::Ok;
  for (auto& texture : *response.mutable_textures()) {
    map::RawSlice slice;
    slice.cell_format = texture.cell_format();
    slice.cells = std::move(*texture.mutable_cells());
    slice.width = texture.width();
    slice.height = texture.height();
    slice.resolution_m = texture.resolution();
    slice.z_level = texture.z_level();
    if (texture.has_slice_pose()) slice.slice_pose = toPose(texture.slice_pose());
    answer.slices.push_back(std::move(slice));
  }
  return answer;
}

map::SubmapList toSubmapList(const ros_messages::slam::SubmapList& message) {
  map::SubmapList list;
  list.uuid = message.uuid();
  list.slam_state = message.slam_state() == ros_messages::slam::SLAM_STATE_SLAM ? map::SlamState::Slam
                    : message.slam_state() == ros_messages::slam::SLAM_STATE_POSITIONING
                        ? map::SlamState::Positioning
                        : map::SlamState::Invalid;
  list.entries.reserve(std::size_t(message.submaps_size()));
  for (const auto& entry : message.submaps()) {
    list.entries.push_back({{entry.trajectory_id(), entry.submap_index()},
                            entry.submap_version(),
                            toPose(entry.pose()),
                            entry.is_frozen(),
                            entry.is_incremental_submap(),
                            entry.is_nearby_map()});
  }
  return list;
}

}  // namespace mapwright::robot::axbot
