#include "simulator/json_shapes.h"

#include "simulator/json_text.h"

namespace mapwright::simulator {

std::string openMessage(std::string_view topic) {
  std::string out = "{\"topic\":";
  appendJsonText(out, topic);
  return out;
}

void appendPoint(std::string& out, const Eigen::Vector2d& point) {
  out += '[';
  appendJsonFixed(out, point.x(), 3);
  out += ',';
  appendJsonFixed(out, point.y(), 3);
  out += ']';
}

void appendPoints(std::string& out, const std::vector<Eigen::Vector2d>& points) {
  out += '[';
  bool first = true;
  for (const Eigen::Vector2d& point : points) {
    if (!first) out += ',';
    first = false;
    appendPoint(out, point);
  }
  out += ']';
}

void appendPose(std::string& out, const geometry::Pose2& pose) {
  out += "{\"pos\":";
  appendPoint(out, {pose.x_m, pose.y_m});
  out += ",\"ori\":";
  appendJsonFixed(out, pose.yaw_rad, 4);
  out += '}';
}

std::vector<Eigen::Vector2d> cornersOf(const geometry::Pose2& pose, double length_m, double width_m) {
  const double l = length_m / 2, w = width_m / 2;
  return {pose.apply({-l, -w}), pose.apply({l, -w}), pose.apply({l, w}), pose.apply({-l, w})};
}

}  // namespace mapwright::simulator
