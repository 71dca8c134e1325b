#include "simulator/ros/shapes.h"

#include <cmath>
#include <limits>

#include "simulator/stamp.h"

namespace mapwright::simulator::ros {
namespace {

constexpr double kSeqPerS = 50;

}  // namespace

Value timeOf(double simulated_s, RosDialect dialect) {
  const double stamp = stampOf(simulated_s);
  const auto whole = static_cast<std::int64_t>(std::floor(stamp));
  const auto nano = static_cast<std::int64_t>((stamp - std::floor(stamp)) * 1e9);
  if (dialect == RosDialect::Ros1) return Value::Object{{"secs", whole}, {"nsecs", nano}};
  return Value::Object{{"sec", whole}, {"nanosec", nano}};
}

Value headerOf(std::string_view frame, double simulated_s, RosDialect dialect) {
  Value header = Value::Object{{"stamp", timeOf(simulated_s, dialect)}, {"frame_id", frame}};
  if (dialect == RosDialect::Ros1) {
    header.set("seq", static_cast<std::int64_t>(std::fmod(simulated_s * kSeqPerS, 4e9)));
  }
  return header;
}

Value xyz(double x, double y, double z) { return Value::Object{{"x", x}, {"y", y}, {"z", z}}; }

Value quaternionOf(double yaw_rad) {
  return Value::Object{{"x", 0.0}, {"y", 0.0}, {"z", std::sin(yaw_rad / 2)}, {"w", std::cos(yaw_rad / 2)}};
}

Value poseOf(const geometry::Pose2& pose, double z_m) {
  return Value::Object{{"position", xyz(pose.x_m, pose.y_m, z_m)},
                       {"orientation", quaternionOf(pose.yaw_rad)}};
}

Value transformOf(const geometry::Pose2& pose, double z_m) {
  return Value::Object{{"translation", xyz(pose.x_m, pose.y_m, z_m)},
                       {"rotation", quaternionOf(pose.yaw_rad)}};
}

Value poseOf(const geometry::Pose2& pose, const RosFaults& faults) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  Value value = poseOf(pose);
  if (faults.nan_pose) value.set("position", xyz(kNan, kNan, 0));
  if (faults.zero_quaternion)
    value.set("orientation", Value::Object{{"x", 0.0}, {"y", 0.0}, {"z", 0.0}, {"w", 0.0}});
  return value;
}

geometry::Pose2 mapFromOdom(double simulated_s) {
  return {0.8 + 0.2 * std::sin(simulated_s / 60), -0.4 + 0.1 * std::cos(simulated_s / 37),
          0.1 + 0.02 * std::sin(simulated_s / 45)};
}

}  // namespace mapwright::simulator::ros
