// The live world of a robot, and the one reducer that builds it from topic messages, live or replayed
// (architecture, decision 2).
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "geometry/pose.h"
#include "map/submap.h"

namespace mapwright::map {

/// /tracked_pose: pos [x,y] metres, ori radians.
struct TrackedPose {
  geometry::Pose2 pose;
};

/// /robot_model: outlines in the robot frame, metres. Empty when unknown.
struct RobotModel {
  std::vector<Eigen::Vector2d> footprint;
  double width_m = 0;
};

/// /slam/state.
struct SlamStatus {
  std::string state;  // inactive, slam, positioning, or whatever the robot says
  std::optional<bool> reliable;
};

/// A message that could not be read, for the list of problems.
struct UnreadableMessage {
  std::string topic;
  std::string reason;
};

using TopicMessage = std::variant<SubmapList, TrackedPose, RobotModel, SlamStatus, UnreadableMessage>;

/// What is known of the robot's world now. Value type; submap lists are handled by submap::SubmapBook.
struct LiveState {
  std::optional<geometry::Pose2> robot_pose;
  std::deque<Eigen::Vector2d> trail;  // oldest first, points at least kTrailStepM apart, at most kTrailPoints
  RobotModel model;
  SlamStatus slam;

  static constexpr double kTrailStepM = 0.05;
  static constexpr std::size_t kTrailPoints = 20'000;
};

/// The state after `message`. Messages that the state does not hold leave it as it is.
LiveState reduce(LiveState state, const TopicMessage& message);

}  // namespace mapwright::map
