#include "robot/pbstream/state_messages.h"

#include <limits>
#include <unordered_map>
#include <utility>

#include "robot/submap_list_topic.h"

namespace mapwright::robot::pbstream {
namespace {

using mapwright::pbstream::StateFile;
using mapwright::pbstream::StoredSubmap;

map::SubmapList listOf(const StateFile& file) {
  map::SubmapList list;
  list.uuid = file.uuid;
  for (const StoredSubmap& submap : file.submaps) {
    const geometry::Pose3* const pose = file.poseOf(submap.id);
    if (!pose) continue;  // StateFile::losses()
    map::SubmapEntry entry;
    entry.id = submap.id;
    entry.version = submap.version;
    entry.pose = *pose;
    list.entries.push_back(entry);
  }
  return list;
}

map::TrajectoryMessage trajectoriesOf(const map::PoseGraph& graph) {
  map::TrajectoryMessage message;
  constexpr double kNowhere = std::numeric_limits<double>::infinity();
  for (const map::Trajectory& trajectory : graph.trajectories) {
    // A line is broken where a point is not finite.
    if (!message.points.empty()) message.points.emplace_back(kNowhere, kNowhere);
    for (const map::TrajectoryNode& node : trajectory.nodes) {
      if (geometry::toIsometry(node.pose)) message.points.emplace_back(node.pose.x, node.pose.y);
    }
  }
  return message;
}

map::ConstraintsMessage constraintsOf(const map::PoseGraph& graph) {
  std::unordered_map<map::SubmapId, Eigen::Isometry3d> submaps;
  for (const map::SubmapPose& submap : graph.submaps) {
    if (const auto pose = geometry::toIsometry(submap.pose)) submaps.emplace(submap.id, *pose);
  }
  // Ids of nodes are pairs of numbers like those of submaps.
  const auto key = [](map::NodeId id) { return map::SubmapId{id.trajectory, id.index}; };
  std::unordered_map<map::SubmapId, Eigen::Vector2d> nodes;
  for (const map::Trajectory& trajectory : graph.trajectories) {
    for (const map::TrajectoryNode& node : trajectory.nodes) {
      if (geometry::toIsometry(node.pose))
        nodes.emplace(key(node.id), Eigen::Vector2d(node.pose.x, node.pose.y));
    }
  }
  map::ConstraintsMessage message;
  for (const map::Constraint& constraint : graph.constraints) {
    const auto submap = submaps.find(constraint.submap);
    const auto node = nodes.find(key(constraint.node));
    const auto relative = geometry::toIsometry(constraint.relative_pose);
    if (submap == submaps.end() || node == nodes.end() || !relative) continue;
    const bool intra = constraint.kind == map::ConstraintKind::Intra;
    const bool same = constraint.submap.trajectory == constraint.node.trajectory;
    const std::string kind = intra ? "Intra " : "Inter ";
    const std::string of = intra ? "" : same ? ", same trajectory" : ", different trajectories";
    const Eigen::Vector2d expected = (submap->second * relative->translation()).head<2>();
    message.by_name[kind + "constraints" + of].emplace_back(submap->second.translation().head<2>(), expected);
    message.by_name[kind + "residuals" + of].emplace_back(expected, node->second);
  }
  return message;
}

map::LandmarksMessage landmarksOf(const map::PoseGraph& graph) {
  map::LandmarksMessage message;
  for (const map::LandmarkPose& landmark : graph.landmarks) {
    if (geometry::toIsometry(landmark.pose))
      message.landmarks.push_back({landmark.id, {landmark.pose.x, landmark.pose.y}, {}});
  }
  return message;
}

}  // namespace

std::vector<map::StampedMessage> messagesOf(const StateFile& file, double received_s) {
  std::vector<map::StampedMessage> messages;
  const auto add = [&](map::TopicMessage message, const char* topic) {
    messages.push_back({std::move(message), received_s, std::nullopt, topic});
  };
  add(listOf(file), kSubmapListTopic);
  add(trajectoriesOf(*file.graph), kTrajectoryTopic);
  add(constraintsOf(*file.graph), kConstraintsTopic);
  add(landmarksOf(*file.graph), kLandmarksTopic);
  return messages;
}

}  // namespace mapwright::robot::pbstream
