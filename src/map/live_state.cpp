#include "map/live_state.h"

#include <utility>

namespace mapwright::map {
namespace {

void extendTrail(std::deque<Eigen::Vector2d>& trail, const Eigen::Vector2d& point) {
  if (!trail.empty() && (trail.back() - point).norm() < LiveState::kTrailStepM) return;
  trail.push_back(point);
  if (trail.size() > LiveState::kTrailPoints) trail.pop_front();
}

}  // namespace

LiveState reduce(LiveState state, const TopicMessage& message) {
  if (const auto* tracked = std::get_if<TrackedPose>(&message)) {
    state.robot_pose = tracked->pose;
    extendTrail(state.trail, {tracked->pose.x_m, tracked->pose.y_m});
  } else if (const auto* model = std::get_if<RobotModel>(&message)) {
    state.model = *model;
  } else if (const auto* slam = std::get_if<SlamStatus>(&message)) {
    state.slam = *slam;
  }
  return state;
}

}  // namespace mapwright::map
