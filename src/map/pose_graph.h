// The pose graph of a Cartographer session as plain values. Poses are global (frame to world), as stored:
// they may be invalid (see geometry::toIsometry). Source: cartographer/mapping/proto/pose_graph.proto.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/pose.h"
#include "map/submap.h"

namespace mapwright::map {

/// A pose of the robot within one SLAM session.
struct NodeId {
  std::int32_t trajectory = 0;
  std::int32_t index = 0;
  auto operator<=>(const NodeId&) const = default;
};

/// "0-512": the displayed name of a node.
std::string toText(NodeId id);

enum class ConstraintKind {
  Intra,  // the scan was inserted into the submap (INTRA_SUBMAP)
  Inter,  // the scan was found in a submap into which it was not inserted: a loop closure (INTER_SUBMAP)
};

/// "The node lies at relative_pose in the frame of the submap."
struct Constraint {
  SubmapId submap;
  NodeId node;
  geometry::Pose3 relative_pose;
  ConstraintKind kind = ConstraintKind::Intra;
  double translation_weight = 0, rotation_weight = 0;
  bool operator==(const Constraint&) const = default;
};

struct TrajectoryNode {
  NodeId id;
  std::optional<double> stamp_s;  // seconds since the epoch; nullopt: not stated
  geometry::Pose3 pose;
  bool operator==(const TrajectoryNode&) const = default;
};

/// One run of the robot. The nodes are in the order of their indices.
struct Trajectory {
  std::int32_t id = 0;
  std::vector<TrajectoryNode> nodes;
  bool operator==(const Trajectory&) const = default;
};

struct SubmapPose {
  SubmapId id;
  geometry::Pose3 pose;
  bool operator==(const SubmapPose&) const = default;
};

struct LandmarkPose {
  std::string id;  // untrusted plain text
  geometry::Pose3 pose;
  bool operator==(const LandmarkPose&) const = default;
};

/// Trajectories and submaps are in the order of their ids, each id once; constraints are as stored, and may
/// name submaps and nodes that do not exist.
struct PoseGraph {
  std::vector<Trajectory> trajectories;
  std::vector<SubmapPose> submaps;
  std::vector<Constraint> constraints;
  std::vector<LandmarkPose> landmarks;
  bool operator==(const PoseGraph&) const = default;
};

}  // namespace mapwright::map
