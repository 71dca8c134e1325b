// Parts that messages of ROS have in common. Private to the readers.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "robot/ros/read_messages.h"

namespace mapwright::robot::ros {

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kFarthestM = 1e7;
/// A shorter quaternion is none.
inline constexpr double kShortestQuaternion = 1e-6;

Header headerOf(const Field& msg);

/// The field cannot be had. `name` as people who know ROS write it: "info.width".
tl::unexpected<Fault> fieldMissing(std::string name);
tl::unexpected<Fault> fieldWrong(std::string name, double value);

/// A number, NaN where it is absent or null.
double numberOr(const Field& field, double fallback);
/// geometry_msgs/Point, Point32, Vector3: NaN where something is missing.
Eigen::Vector3d pointOf(const Field& field);
/// geometry_msgs/Quaternion: (0, 0, 0, 0) where something is missing.
Eigen::Quaterniond quaternionOf(const Field& field);

/// geometry_msgs/Pose. A quaternion that is zero, or no number, is no turn, and `upright` says so.
struct PoseRead {
  Transform3 pose;  // x and y hold NaN where the message does
  bool upright = false;
};
PoseRead poseOf(const Field& field);

/// Which of `count` things to take so that at most `most` remain: each n-th.
inline std::size_t strideFor(std::size_t count, std::size_t most) {
  return count / most + (count % most != 0);
}

/// Points in the making. Intensities come in units of the sensor's own: all of them together tell which.
class PointList {
 public:
  void reserve(std::size_t count);
  /// What is not finite, or farther than 10,000 km, is left out: false.
  bool add(double x_m, double y_m, double z_m, double intensity);
  void leaveOut() { ++left_out_; }
  /// `bytes`: intensities are 0..255 whatever they look like.
  Points points(Header header, bool bytes) &&;

 private:
  std::vector<map::CloudPoint> points_;
  std::vector<float> intensities_;
  float brightest_ = 0;
  std::size_t left_out_ = 0;
};

}  // namespace mapwright::robot::ros
