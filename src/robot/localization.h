// The port: telling a robot where it is. Source: docs/protocols/autoxing.md, "What changes a robot".
#pragma once

#include <optional>
#include <string>

#include "geometry/pose.h"
#include "map/live_topics.h"
#include "robot/call.h"

namespace mapwright::robot {

/// Where the robot is told to be, on its current map.
struct PoseOrder {
  geometry::Pose2 pose;
  bool adjust = false;  // it may correct the pose by what its sensors see
};

/// Capability: set where the robot believes to be. Nothing is sent twice.
class Localization {
 public:
  virtual ~Localization() = default;
  /// The answer is the pose that the robot reports afterwards, which may be another one. If it reports none
  /// the failure's applied is Maybe.
  virtual Call setPose(const PoseOrder& order, OutcomeTo<geometry::Pose2> reply) = 0;
  /// Makes the robot look for itself on the whole map. The answer is the result that it reports; one with
  /// `needs_confirmation` is only proposed: setPose() accepts it.
  virtual Call findItself(OutcomeTo<map::GlobalPositioning> reply) = 0;
};

}  // namespace mapwright::robot
