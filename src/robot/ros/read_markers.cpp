// Markers. Source: visualization_msgs/Marker.
#include <algorithm>
#include <cmath>

#include "robot/ros/parts.h"

namespace mapwright::robot::ros {
namespace {

constexpr std::size_t kMostMarkers = 20'000;
constexpr std::size_t kMostMarkerPoints = 100'000;
constexpr std::size_t kMostPointsOfAll = 500'000;

Marker::Kind kindOf(std::int64_t type) {
  using Kind = Marker::Kind;
  switch (type) {
    case 0:
      return Kind::Arrow;
    case 1:
      return Kind::Cube;
    case 2:
      return Kind::Sphere;
    case 3:
      return Kind::Cylinder;
    case 4:
      return Kind::LineStrip;
    case 5:
      return Kind::LineList;
    case 6:
      return Kind::CubeList;
    case 7:
      return Kind::SphereList;
    case 8:
      return Kind::Points;
    case 9:
      return Kind::Text;
    case 11:
      return Kind::Triangles;
    case 12:  // a chain of arrows (newer ROS 2)
      return Kind::LineStrip;
    default:
      return Kind::Other;
  }
}

/// 1 has no meaning.
std::optional<Marker::Action> actionOf(std::int64_t action) {
  if (action == 0) return Marker::Action::Add;
  if (action == 2) return Marker::Action::Delete;
  if (action == 3) return Marker::Action::DeleteAll;
  return std::nullopt;
}

std::uint32_t rgbaOf(const Field& color) {
  std::uint32_t rgba = 0;
  for (const char* const channel : {"r", "g", "b", "a"}) {
    const double level = std::clamp(numberOr(color[channel], 1), 0.0, 1.0);
    rgba = rgba << 8 | std::uint32_t(std::lround(level * 255));
  }
  return rgba;
}

/// At most `most` points, with their colours if there are as many.
void readPoints(const Field& field, std::size_t most, Marker& marker) {
  std::vector<bool> taken;
  field["points"].each([&](const Field& item) {
    if (marker.points.size() >= most) return;
    Eigen::Vector3d point = pointOf(item);
    if (std::isnan(point.z())) point.z() = 0;
    taken.push_back(point.allFinite());
    if (taken.back()) marker.points.push_back(point);
  });
  const Field colors = field["colors"];
  if (colors.size() < taken.size() || taken.empty()) return;
  std::size_t at = 0;
  colors.each([&](const Field& item) {
    if (at < taken.size() && taken[at]) marker.colors.push_back(rgbaOf(item));
    ++at;
  });
}

std::optional<Marker> markerOf(const Field& field, std::size_t most_points) {
  const auto action = actionOf(field["action"].integer().value_or(0));
  if (!action) return std::nullopt;
  const PoseRead pose = poseOf(field["pose"]);
  Marker marker;
  marker.header = headerOf(field);
  marker.ns = field["ns"].text();
  marker.id = field["id"].integer().value_or(0);
  marker.action = *action;
  if (*action != Marker::Action::Add) return marker;
  if (!pose.pose.t_m.allFinite()) return std::nullopt;
  marker.kind = kindOf(field["type"].integer().value_or(-1));
  marker.pose = pose.pose;
  marker.upright = pose.upright;
  const Eigen::Vector3d scale = pointOf(field["scale"]);
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    marker.scale_m[axis] = std::isfinite(scale[axis]) ? std::abs(scale[axis]) : 0;
  marker.rgba = rgbaOf(field["color"]);
  marker.text = field["text"].text();
  marker.lifetime_s = std::max(0.0, field["lifetime"].time().value_or(0));
  marker.frame_locked = field["frame_locked"].flag().value_or(false);
  readPoints(field, most_points, marker);
  return marker;
}

}  // namespace

Read<std::vector<Marker>> readMarkers(const Field& msg) {
  std::vector<Marker> markers;
  std::size_t points = 0;
  const auto take = [&](const Field& field) {
    if (markers.size() >= kMostMarkers) return;
    auto marker = markerOf(field, std::min(kMostMarkerPoints, kMostPointsOfAll - points));
    if (!marker) return;
    points += marker->points.size();
    markers.push_back(std::move(*marker));
  };
  const Field list = msg["markers"];
  if (list.isList()) {
    list.each(take);
  } else if (msg["type"].isNumber()) {
    take(msg);
  } else {
    return fieldMissing("markers");
  }
  return markers;
}

}  // namespace mapwright::robot::ros
