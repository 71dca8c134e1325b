#include "map/closures.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace mapwright::map {
namespace {

std::uint64_t packed(std::int32_t trajectory, std::int32_t index) {
  return (std::uint64_t(std::uint32_t(trajectory)) << 32) | std::uint32_t(index);
}

}  // namespace

std::optional<double> medianOf(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

Closures rankClosures(const PoseGraph& graph) {
  std::unordered_map<std::uint64_t, const geometry::Pose3*> submaps;
  for (const SubmapPose& submap : graph.submaps)
    submaps.emplace(packed(submap.id.trajectory, submap.id.index), &submap.pose);
  std::unordered_map<std::uint64_t, const TrajectoryNode*> nodes;
  for (const Trajectory& trajectory : graph.trajectories) {
    for (const TrajectoryNode& node : trajectory.nodes)
      nodes.emplace(packed(node.id.trajectory, node.id.index), &node);
  }
  Closures closures;
  std::vector<double> inter, intra;
  for (std::size_t i = 0; i < graph.constraints.size(); ++i) {
    const Constraint& constraint = graph.constraints[i];
    const bool is_inter = constraint.kind == ConstraintKind::Inter;
    const auto submap = submaps.find(packed(constraint.submap.trajectory, constraint.submap.index));
    const auto node = nodes.find(packed(constraint.node.trajectory, constraint.node.index));
    if (submap == submaps.end() || node == nodes.end()) {
      ++closures.dangling;
      continue;
    }
    ++(is_inter ? closures.inter : closures.intra);
    const auto world_from_submap = geometry::toIsometry(*submap->second);
    const auto world_from_node = geometry::toIsometry(node->second->pose);
    const auto submap_from_node = geometry::toIsometry(constraint.relative_pose);
    Closure closure{constraint.submap, constraint.node, constraint.kind, NAN, NAN, {}, {}, {}, i};
    if (world_from_submap && world_from_node && submap_from_node) {
      const Eigen::Vector3d expected = *world_from_submap * submap_from_node->translation();
      // The rotation into the submap's frame changes no length.
      closure.residual_m = (expected - world_from_node->translation()).norm();
      const auto yaw = [](const Eigen::Isometry3d& pose) { return geometry::projectToPlane(pose).yaw_rad; };
      closure.residual_rad = std::abs(geometry::normalizeAngle(
          yaw(*submap_from_node) - (yaw(*world_from_node) - yaw(*world_from_submap))));
      closure.at = world_from_node->translation().head<2>();
      closure.expected = expected.head<2>();
      closure.stamp_s = node->second->stamp_s;
    }
    if (!std::isfinite(closure.residual_m)) {
      ++closures.without_pose;
      continue;
    }
    (is_inter ? inter : intra).push_back(closure.residual_m);
    closures.ranked.push_back(closure);
  }
  closures.inter_median_m = medianOf(std::move(inter));
  closures.intra_median_m = medianOf(std::move(intra));
  std::sort(closures.ranked.begin(), closures.ranked.end(), [](const Closure& a, const Closure& b) {
    return std::tuple(-a.residual_m, -a.residual_rad, a.submap, a.node, a.constraint) <
           std::tuple(-b.residual_m, -b.residual_rad, b.submap, b.node, b.constraint);
  });
  return closures;
}

}  // namespace mapwright::map
