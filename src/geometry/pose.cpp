#include "geometry/pose.h"

#include <cmath>
#include <numbers>

namespace mapwright::geometry {

Eigen::Vector2d Pose2::apply(const Eigen::Vector2d& p) const {
  const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
  return {c * p.x() - s * p.y() + x_m, s * p.x() + c * p.y() + y_m};
}

Pose2 Pose2::operator*(const Pose2& child) const {
  const Eigen::Vector2d origin = apply({child.x_m, child.y_m});
  return {origin.x(), origin.y(), normalizeAngle(yaw_rad + child.yaw_rad)};
}

Pose2 Pose2::inverse() const {
  const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
  return {-(c * x_m + s * y_m), -(-s * x_m + c * y_m), normalizeAngle(-yaw_rad)};
}

std::optional<Eigen::Isometry3d> toIsometry(const Pose3& pose) {
  for (const double value : {pose.x, pose.y, pose.z, pose.qx, pose.qy, pose.qz, pose.qw}) {
    if (!std::isfinite(value)) return std::nullopt;
  }
  const Eigen::Quaterniond q(pose.qw, pose.qx, pose.qy, pose.qz);
  const double length = q.norm();
  if (!std::isfinite(length) || length < 1e-6) return std::nullopt;
  Eigen::Isometry3d transform = Eigen::Isometry3d::Identity();
  transform.linear() = Eigen::Quaterniond(q.coeffs() / length).toRotationMatrix();
  transform.translation() = Eigen::Vector3d(pose.x, pose.y, pose.z);
  return transform;
}

Pose2 projectToPlane(const Eigen::Isometry3d& transform) {
  return {transform.translation().x(), transform.translation().y(),
          std::atan2(transform.linear()(1, 0), transform.linear()(0, 0))};
}

Pose3 poseFromYaw(double x_m, double y_m, double yaw_rad) {
  return {x_m, y_m, 0, 0, 0, std::sin(yaw_rad / 2), std::cos(yaw_rad / 2)};
}

double normalizeAngle(double rad) {
  const double folded = std::remainder(rad, 2 * std::numbers::pi);
  return folded <= -std::numbers::pi ? folded + 2 * std::numbers::pi : folded;
}

}  // namespace mapwright::geometry
