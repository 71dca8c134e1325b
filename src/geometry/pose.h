// Rigid poses: as robots send them (3D, quaternion) and as the map draws them (2D, yaw).
#pragma once

#include <optional>

#include <Eigen/Geometry>

namespace mapwright::geometry {

/// A pose as received: metres, and a quaternion that may be un-normalised, zero or NaN. Source:
/// docs/protocols/cartographer-submaps.md, "Messages".
struct Pose3 {
  double x = 0, y = 0, z = 0;
  double qx = 0, qy = 0, qz = 0, qw = 1;
  bool operator==(const Pose3&) const = default;
};

/// A rigid transform of the plane: p_parent = R(yaw_rad) * p_child + (x_m, y_m). Metres, radians,
/// counter-clockwise.
struct Pose2 {
  double x_m = 0, y_m = 0, yaw_rad = 0;
  bool operator==(const Pose2&) const = default;

  Eigen::Vector2d apply(const Eigen::Vector2d& p) const;
  Pose2 operator*(const Pose2& child) const;
  Pose2 inverse() const;
};

/// The transform of a received pose. Quaternions are normalised; nullopt if a number is not finite or the
/// quaternion has no direction (length below 1e-6).
std::optional<Eigen::Isometry3d> toIsometry(const Pose3& pose);

/// Projects a 3D transform onto the plane z = 0: the yaw is that of the projected x axis. Source:
/// docs/protocols/cartographer-submaps.md, "Geometry" (multiply the full transforms first, project last).
Pose2 projectToPlane(const Eigen::Isometry3d& transform);

/// A 3D pose at (x, y) with the given yaw.
Pose3 poseFromYaw(double x_m, double y_m, double yaw_rad);

/// The angle normalised to (-pi, pi].
double normalizeAngle(double rad);

constexpr double degreesFromRadians(double rad) { return rad * 57.295779513082320876798154814105; }
constexpr double radiansFromDegrees(double deg) { return deg * 0.017453292519943295769236907684886; }

}  // namespace mapwright::geometry
