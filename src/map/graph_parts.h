// Parts of a pose graph, with all that belongs to them.
#pragma once

#include <cstdint>
#include <set>
#include <utility>

#include "map/pose_graph.h"

namespace mapwright::map {

struct GraphParts {
  std::set<std::int32_t> trajectories;
  std::set<SubmapId> submaps;
  /// Loop closures (ConstraintKind::Inter) between a submap and a node.
  std::set<std::pair<SubmapId, NodeId>> closures;
  bool empty() const { return trajectories.empty() && submaps.empty() && closures.empty(); }
};

}  // namespace mapwright::map
