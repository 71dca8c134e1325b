// Common parts of ROS messages. Private to the readers.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "robot/ros/read_messages.h"

namespace mapwright::robot::ros {

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kFarthestM = 1e7;
/// A shorter quaternion counts as zero.
inline constexpr double kShortestQuaternion = 1e-6;

Header headerOf(const Field& msg);

/// The field is missing. `name` as ROS users write it: "info.width".
tl::unexpected<Fault> fieldMissing(std::string name);
tl::unexpected<Fault> fieldWrong(std::string name, double value);

/// A number, or `fallback` if it is absent or null.
double numberOr(const Field& field, double fallback);
/// geometry_msgs/Point, Point32, Vector3: NaN for missing members.
Eigen::Vector3d pointOf(const Field& field);
/// geometry_msgs/Quaternion: (0, 0, 0, 0) if a member is missing.
Eigen::Quaterniond quaternionOf(const Field& field);

/// geometry_msgs/Pose. A quaternion that is zero or not a number counts as no rotation, and sets `upright`.
struct PoseRead {
  Transform3 pose;  // x and y are NaN if the message says so
  bool upright = false;
};
PoseRead poseOf(const Field& field);

/// The stride for taking at most `most` of `count` things: each n-th.
inline std::size_t strideFor(std::size_t count, std::size_t most) {
  return count / most + (count % most != 0);
}

/// Collects points. The unit of intensities depends on the sensor and is derived from all of them.
class PointList {
 public:
  void reserve(std::size_t count);
  /// Points that are not finite, or farther than 10,000 km, are skipped: false.
  bool add(double x_m, double y_m, double z_m, double intensity);
  void leaveOut() { ++left_out_; }
  /// `bytes`: intensities are 0..255 in any case.
  Points points(Header header, bool bytes) &&;

 private:
  std::vector<map::CloudPoint> points_;
  std::vector<float> intensities_;
  float brightest_ = 0;
  std::size_t left_out_ = 0;
};

}  // namespace mapwright::robot::ros
