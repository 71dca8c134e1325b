#include "simulator/json_shapes.h"

#include "simulator/json_text.h"
#include "simulator/value_json.h"

namespace mapwright::simulator {
namespace {

void appendPoint(std::string& out, const Eigen::Vector2d& point) {
  out += '[';
  appendJsonFixed(out, point.x(), 3);
  out += ',';
  appendJsonFixed(out, point.y(), 3);
  out += ']';
}

}  // namespace

Value pointOf(const Eigen::Vector2d& point) {
  Value::Json json;
  appendPoint(json.text, point);
  return {std::move(json)};
}

Value pointsOf(const std::vector<Eigen::Vector2d>& points) {
  Value::Json json{"["};
  for (const Eigen::Vector2d& point : points) {
    if (json.text.size() > 1) json.text += ',';
    appendPoint(json.text, point);
  }
  json.text += ']';
  return {std::move(json)};
}

Value placeOf(const geometry::Pose2& pose) {
  return Value::Object{{"pos", pointOf({pose.x_m, pose.y_m})}, {"ori", fixed(pose.yaw_rad, 4)}};
}

std::vector<Eigen::Vector2d> cornersOf(const geometry::Pose2& pose, double length_m, double width_m) {
  const double l = length_m / 2, w = width_m / 2;
  return {pose.apply({-l, -w}), pose.apply({l, -w}), pose.apply({l, w}), pose.apply({-l, w})};
}

std::string messageJson(std::string_view topic, Value::Object members) {
  members.emplace(members.begin(), "topic", topic);
  return toJson(members);
}

Value ownUrl(std::string_view path) { return "http://192.168.25.25:8090" + std::string(path); }

}  // namespace mapwright::simulator
