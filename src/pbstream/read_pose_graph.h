// Reads the record that holds the pose graph.
#pragma once

#include <tl/expected.hpp>

#include "map/pose_graph.h"
#include "pbstream/wire.h"

namespace mapwright::pbstream {

struct ReadGraph {
  map::PoseGraph graph;
  std::vector<Fault> odd;  // read all the same
};

/// `wire` stands at the member that holds it. Its fault() says what is wrong.
ReadGraph readPoseGraph(Wire& wire);

/// Ticks of 100 ns since 0001-01-01 as seconds since the epoch; nullopt: it says none.
std::optional<double> secondsFromTicks(std::int64_t ticks);

}  // namespace mapwright::pbstream
