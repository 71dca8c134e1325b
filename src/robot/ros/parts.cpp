#include "robot/ros/parts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "robot/ros/faults.h"

namespace mapwright::robot::ros {
Header headerOf(const Field& msg) {
  const Field header = msg["header"];
  Header read;
  read.frame = frameName(header["frame_id"].text());
  read.stamp_s = header["stamp"].time();
  if (read.stamp_s == 0.0) read.stamp_s.reset();
  return read;
}

tl::unexpected<Fault> fieldMissing(std::string name) {
  return tl::unexpected(Fault(fault::RosFieldMissing, {std::move(name)}));
}

tl::unexpected<Fault> fieldWrong(std::string name, double value) {
  return tl::unexpected(Fault(fault::RosFieldWrong, {std::move(name), value}));
}

double numberOr(const Field& field, double fallback) { return field.number().value_or(fallback); }

Eigen::Vector3d pointOf(const Field& field) {
  return {numberOr(field["x"], kNaN), numberOr(field["y"], kNaN), numberOr(field["z"], kNaN)};
}

Eigen::Quaterniond quaternionOf(const Field& field) {
  const Eigen::Quaterniond q(numberOr(field["w"], kNaN), numberOr(field["x"], kNaN),
                             numberOr(field["y"], kNaN), numberOr(field["z"], kNaN));
  return q.coeffs().allFinite() ? q : Eigen::Quaterniond(0, 0, 0, 0);
}

PoseRead poseOf(const Field& field) {
  PoseRead read;
  read.pose.t_m = pointOf(field["position"]);
  if (std::isnan(read.pose.t_m.z())) read.pose.t_m.z() = 0;  // irrelevant in the plane
  const Eigen::Quaterniond q = quaternionOf(field["orientation"]);
  const double length = q.norm();
  read.upright = !std::isfinite(length) || length < kShortestQuaternion;
  if (!read.upright) read.pose.q = Eigen::Quaterniond(q.coeffs() / length);
  return read;
}

void PointList::reserve(std::size_t count) {
  points_.reserve(count);
  intensities_.reserve(count);
}

bool PointList::add(double x_m, double y_m, double z_m, double intensity) {
  if (!(std::abs(x_m) <= kFarthestM) || !(std::abs(y_m) <= kFarthestM) || !(std::abs(z_m) <= kFarthestM)) {
    leaveOut();
    return false;
  }
  points_.push_back({x_m, y_m, float(z_m), 0});
  const float kept = intensity > 0 && std::isfinite(intensity) ? float(std::min(intensity, 1e30)) : 0;
  brightest_ = std::max(brightest_, kept);
  intensities_.push_back(kept);
  return true;
}

Points PointList::points(Header header, bool bytes) && {
  // 0..1, 0..255, or counts of the sensor without a known maximum.
  const float scale = bytes || (brightest_ > 1 && brightest_ <= 255) ? 1
                      : brightest_ <= 1                              ? 255
                                                                     : 255 / brightest_;
  for (std::size_t i = 0; i < points_.size() && brightest_ > 0; ++i)
    points_[i].intensity = std::uint8_t(std::min(255.0f, intensities_[i] * scale + 0.5f));
  Points all;
  all.header = std::move(header);
  all.points = std::move(points_);
  all.left_out = left_out_;
  return all;
}

}  // namespace mapwright::robot::ros
