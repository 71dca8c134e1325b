// Small messages used in many others, and the frames of the simulated robot.
#pragma once

#include <string_view>

#include "geometry/pose.h"
#include "simulator/ros/ros_options.h"
#include "simulator/simulator.h"
#include "simulator/value.h"

namespace mapwright::simulator::ros {

/// {"secs","nsecs"} or {"sec","nanosec"}, of simulated time.
Value timeOf(double simulated_s, RosDialect dialect);
/// With seq on ROS 1. It is derived from the time, so that a paused robot repeats itself.
Value headerOf(std::string_view frame, double simulated_s, RosDialect dialect);
Value xyz(double x, double y, double z);  // Point, Vector3, Point32
Value quaternionOf(double yaw_rad);
Value poseOf(const geometry::Pose2& pose, double z_m = 0);
/// The same as a Transform: translation and rotation.
Value transformOf(const geometry::Pose2& pose, double z_m = 0);

/// A pose with the effects of the faults: NaN, or a zero quaternion.
Value poseOf(const geometry::Pose2& pose, const RosFaults& faults);

/// The pose of the frame odom in map: it drifts.
geometry::Pose2 mapFromOdom(double simulated_s);
/// The pose of the lidar: backwards on the robot.
constexpr geometry::Pose2 kBaseFromLaser{0.18, 0, 3.14159265358979323846};
constexpr double kLaserHeightM = 0.22;
/// The robot's footprint.
constexpr double kLengthM = 0.62, kWidthM = 0.46;

}  // namespace mapwright::simulator::ros
