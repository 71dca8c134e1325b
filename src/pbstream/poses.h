// Ids and poses of Cartographer's messages as values.
#pragma once

#include "cartographer/state.pb.h"
#include "map/pose_graph.h"

namespace mapwright::pbstream {

inline map::SubmapId idFrom(const cartographer_state::SubmapId& id) {
  return {id.trajectory_id(), id.submap_index()};
}

/// As stored. A rotation that is left out has no direction, as everything of it is 0.
inline geometry::Pose3 poseFrom(const cartographer_state::Rigid3d& pose) {
  const auto& at = pose.translation();
  const auto& turn = pose.rotation();
  return {at.x(), at.y(), at.z(), turn.x(), turn.y(), turn.z(), turn.w()};
}

}  // namespace mapwright::pbstream
