// Common parts of ROS messages. Private to the readers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "robot/ros/read_messages.h"

namespace mapwright::robot::ros {

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kFarthestM = 1e7;
/// Finite, and not farther away than that along any axis.
bool isPlace(const auto& at_m) { return (at_m.array().abs() <= kFarthestM).all(); }
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

/// The stride for taking at most `most` of `count` things: each n-th; at least 1.
inline std::size_t strideFor(std::size_t count, std::size_t most) {
  return count == 0 ? 1 : count / most + (count % most != 0);
}

/// How to treat invalid cells.
enum class OddCells {
  Unknown,
  Nearest,  // above 100 counts as 100; others as unknown
};

/// Width and height of a grid with at most `most` cells.
struct GridSize {
  std::int64_t width = 0, height = 0;
};
enum class EmptyGrids { Refused, Taken };
/// `prefix` as ROS users write the path of the two: "info."
Read<GridSize> readGridSize(const Field& of, const std::string& prefix, std::int64_t most, EmptyGrids empty);

/// nav_msgs/OccupancyGrid.
Read<Grid> readGridOf(const Field& msg, std::int64_t most_cells, EmptyGrids empty, OddCells odd);

/// The cell edge in metres; NaN if invalid. It is sent as a 32-bit float, so 0.05 arrives as
/// 0.05000000074505806: at a distance of a kilometre cell edges would be on the wrong side. The result is the
/// shortest decimal number with the same float value (docs/protocols/rosbridge.md, "JSON details").
double resolutionOf(const Field& info);

}  // namespace mapwright::robot::ros
