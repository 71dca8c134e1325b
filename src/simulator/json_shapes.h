// The small shapes that many topics share.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "geometry/pose.h"

namespace mapwright::simulator {

/// {"topic":"...", with the brace left open.
std::string openMessage(std::string_view topic);
/// [x,y]
void appendPoint(std::string& out, const Eigen::Vector2d& point);
/// [[x,y],...]
void appendPoints(std::string& out, const std::vector<Eigen::Vector2d>& points);
/// {"pos":[x,y],"ori":rad}
void appendPose(std::string& out, const geometry::Pose2& pose);
/// The corners of a rectangle around a pose, not closed.
std::vector<Eigen::Vector2d> cornersOf(const geometry::Pose2& pose, double length_m, double width_m);

}  // namespace mapwright::simulator
