// Poses, lines of poses, transforms.
#include <cmath>

#include "robot/ros/parts.h"

namespace mapwright::robot::ros {
namespace {

constexpr std::size_t kMostTransforms = 10'000;

Read<Placed> placedBy(const Field& msg, const Field& pose, const std::string& name) {
  const PoseRead read = poseOf(pose);
  if (!std::isfinite(read.pose.t_m.x())) return fieldMissing(name + ".position.x");
  if (!std::isfinite(read.pose.t_m.y())) return fieldMissing(name + ".position.y");
  Placed placed;
  placed.header = headerOf(msg);
  placed.pose = read.pose.flat();
  placed.upright = read.upright;
  return placed;
}

template <class PointAt>
Outline outlineOf(const Field& msg, const Field& list, const PointAt& point_at) {
  Outline outline;
  outline.header = headerOf(msg);
  const std::size_t stride = std::max<std::size_t>(1, strideFor(list.size(), kMostOutlinePoints));
  std::size_t place = 0;
  list.each([&](const Field& item) {
    if (place++ % stride != 0) return;
    const Eigen::Vector2d point = pointOf(point_at(item)).template head<2>();
    if (point.allFinite()) {
      outline.points.push_back(point);
    } else {
      ++outline.left_out;
    }
  });
  return outline;
}

}  // namespace

Read<Outline> readPath(const Field& msg) {
  const Field poses = msg["poses"];
  if (!poses.isList()) return fieldMissing("poses");
  Outline path = outlineOf(msg, poses, [](const Field& item) { return item["pose"]["position"]; });
  if (!path.header.frame.empty()) return path;
  bool first = true;
  poses.each([&](const Field& item) {
    if (std::exchange(first, false)) path.header.frame = headerOf(item).frame;
  });
  return path;
}

Read<Outline> readPolygon(const Field& msg) {
  const Field points = msg["polygon"]["points"];
  if (!points.isList()) return fieldMissing("polygon.points");
  return outlineOf(msg, points, [](const Field& item) { return item; });
}

Read<Placed> readPoseStamped(const Field& msg) { return placedBy(msg, msg["pose"], "pose"); }

Read<Placed> readPoseWithCovariance(const Field& msg) {
  return placedBy(msg, msg["pose"]["pose"], "pose.pose");
}

Read<Placed> readOdometry(const Field& msg) {
  return readPoseWithCovariance(msg).map([&](Placed placed) {
    placed.child_frame = frameName(msg["child_frame_id"].text());
    return placed;
  });
}

Read<Poses> readPoseArray(const Field& msg) {
  const Field list = msg["poses"];
  if (!list.isList()) return fieldMissing("poses");
  Poses all;
  all.header = headerOf(msg);
  const std::size_t stride = std::max<std::size_t>(1, strideFor(list.size(), kMostPoses));
  std::size_t place = 0;
  list.each([&](const Field& item) {
    if (place++ % stride != 0) return;
    const geometry::Pose2 pose = poseOf(item).pose.flat();
    if (std::isfinite(pose.x_m) && std::isfinite(pose.y_m)) all.poses.push_back(pose);
  });
  return all;
}

std::vector<TfRow> readTf(const Field& msg) {
  std::vector<TfRow> rows;
  msg["transforms"].each([&rows](const Field& item) {
    if (rows.size() >= kMostTransforms) return;
    const Header header = headerOf(item);
    TfRow row;
    row.parent = header.frame;
    row.child = frameName(item["child_frame_id"].text());
    if (row.parent.empty() || row.child.empty()) return;
    row.transform = {pointOf(item["transform"]["translation"]), quaternionOf(item["transform"]["rotation"])};
    row.stamp_s = header.stamp_s.value_or(0);
    rows.push_back(std::move(row));
  });
  return rows;
}

std::string plainType(std::string_view type) {
  const std::size_t package = type.find('/'), name = type.rfind('/');
  if (package == std::string_view::npos || package == name) return std::string(type);
  return std::string(type.substr(0, package)).append(type.substr(name));
}

}  // namespace mapwright::robot::ros
