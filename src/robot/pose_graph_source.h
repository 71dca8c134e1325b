// The port: the pose graph of a SLAM session.
#pragma once

#include <memory>

#include "map/pose_graph.h"
#include "robot/call.h"

namespace mapwright::robot {

/// Capability: trajectories, submaps and constraints as a whole, with their ids.
class PoseGraphSource {
 public:
  virtual ~PoseGraphSource() = default;
  /// Never null. Robot::mapsChanged() says that there may be another one.
  virtual Call fetch(OutcomeTo<std::shared_ptr<const map::PoseGraph>> reply) = 0;
};

}  // namespace mapwright::robot
