// How far the constraints of a finished pose graph are from what it makes of them. Source:
// docs/protocols/pbstream.md, "Residuals". They are not ranked by the optimiser's cost: its Huber loss
// silences exactly those that stick out.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "map/pose_graph.h"

namespace mapwright::map {

/// A constraint and how much it contradicts the finished map. Which of the two is wrong is not known.
struct Closure {
  SubmapId submap;
  NodeId node;
  ConstraintKind kind = ConstraintKind::Intra;
  double residual_m = 0;           // over x, y and z of the submap's frame; in 2D every z is 0
  double residual_rad = 0;         // of the yaw, 0..pi
  Eigen::Vector2d at{0, 0};        // world: where the node lies
  Eigen::Vector2d expected{0, 0};  // world: where it would lie by the constraint
  std::optional<double> stamp_s;   // of the node, seconds since the epoch
  std::size_t constraint = 0;      // index in the graph
};

struct Closures {
  std::vector<Closure> ranked;       // most metres first, then most radians, then by ids
  std::size_t inter = 0, intra = 0;  // constraints of each kind, with those that have no pose
  std::size_t dangling = 0;          // neither: their submap or node does not exist
  std::size_t without_pose = 0;      // not ranked: a pose is not finite, or its quaternion has no direction
  std::optional<double> inter_median_m, intra_median_m;  // of those ranked; nullopt: none
};

Closures rankClosures(const PoseGraph& graph);
/// Of an even number the mean of the two in the middle; nullopt: there are none.
std::optional<double> medianOf(std::vector<double> values);

}  // namespace mapwright::map
