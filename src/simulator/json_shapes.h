// Small JSON shapes that many of the Autoxing robot's messages share.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "geometry/pose.h"
#include "simulator/value.h"

namespace mapwright::simulator {

/// [x,y]
Value pointOf(const Eigen::Vector2d& point);
/// [[x,y],...]
Value pointsOf(const std::vector<Eigen::Vector2d>& points);
/// {"pos":[x,y],"ori":rad}
Value placeOf(const geometry::Pose2& pose);
/// The corners of a rectangle around a pose, not closed.
std::vector<Eigen::Vector2d> cornersOf(const geometry::Pose2& pose, double length_m, double width_m);

/// {"topic":"...",...}
std::string messageJson(std::string_view topic, Value::Object members);
/// A path on the host name that the robot uses for itself: these robots put it into their answers, whatever
/// address the client used.
Value ownUrl(std::string_view path);

}  // namespace mapwright::simulator
