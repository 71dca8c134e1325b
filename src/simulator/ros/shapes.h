// The small messages that many others hold, and where the simulated robot's frames are.
#pragma once

#include <string_view>

#include "geometry/pose.h"
#include "simulator/ros/ros_options.h"
#include "simulator/simulator.h"
#include "simulator/value.h"

namespace mapwright::simulator::ros {

/// {"secs","nsecs"} or {"sec","nanosec"}, of simulated time.
Value timeOf(double simulated_s, RosDialect dialect);
/// With seq on ROS 1. It follows from the time, so that a paused robot says the same again.
Value headerOf(std::string_view frame, double simulated_s, RosDialect dialect);
Value xyz(double x, double y, double z);  // Point, Vector3, Point32
Value quaternionOf(double yaw_rad);
Value poseOf(const geometry::Pose2& pose, double z_m = 0);
/// The same as a Transform: translation and rotation.
Value transformOf(const geometry::Pose2& pose, double z_m = 0);

/// A pose as it is sent under these faults: not a number, an orientation of zeros.
Value poseOf(const geometry::Pose2& pose, const RosFaults& faults);

/// Where the frame odom lies in map: it drifts.
geometry::Pose2 mapFromOdom(double simulated_s);
/// Where the lidar sits: backwards on the robot.
constexpr geometry::Pose2 kBaseFromLaser{0.18, 0, 3.14159265358979323846};
constexpr double kLaserHeightM = 0.22;
/// The robot's outline.
constexpr double kLengthM = 0.62, kWidthM = 0.46;

}  // namespace mapwright::simulator::ros
