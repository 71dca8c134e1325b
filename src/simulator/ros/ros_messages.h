// The messages of the simulated ROS robot about itself, and the small ones that others are made of: functions
// of the robot's clock and faults.
#pragma once

#include <memory>
#include <string_view>

#include "geometry/pose.h"
#include "simulator/ros/kabam_store.h"

namespace mapwright::simulator::ros {

/// {"secs","nsecs"} or {"sec","nanosec"}, of simulated time.
Value timeOf(double simulated_s, RosDialect dialect);
/// With seq on ROS 1. It is derived from the time, so that a paused robot repeats itself.
Value headerOf(std::string_view frame, double simulated_s, RosDialect dialect);
Value xyz(double x, double y, double z);  // Point, Vector3, Point32
Value quaternion(double z, double w);
Value poseOf(const geometry::Pose2& pose, double z_m = 0);
/// As the faults leave it: NaN, or a zero quaternion.
Value poseOf(const geometry::Pose2& pose, const RosFaults& faults, double z_m = 0);
/// nav_msgs/MapMetaData.
Value mapInfo(double resolution_m, int width, int height, const geometry::Pose2& origin, RosDialect dialect);

/// The pose of the frame odom in map: it drifts.
geometry::Pose2 mapFromOdom(double simulated_s);

/// Occupancy, row 0 at the bottom.
struct OccupancyCells {
  GridPlace place;
  Value::Int8s cells;
};

using CostsCache = Cache<RasterSource, std::shared_ptr<const OccupancyCells>>;

/// The input for all messages at one time.
struct Moment {
  const RobotState& robot;
  const KabamStore& kabam;
  MapPictures& pictures;
  CostsCache& costs;  // of whole maps
  const Options& options;
  const RosFaults& faults;
  double time_s = 0;
  geometry::Pose2 pose;  // of base_link in map

  RosDialect dialect() const { return options.ros.dialect; }
  geometry::Pose2 odomFromBase() const { return mapFromOdom(time_s).inverse() * pose; }
  /// A message with its header before the other members.
  Value stamped(std::string_view frame, Value::Object members) const;
};

Value tfMessage(const Moment& moment);
Value tfStaticMessage(const Moment& moment);
Value odometryMessage(const Moment& moment);
Value amclPoseMessage(const Moment& moment);
Value goalMessage(const Moment& moment);
/// From the robot on; `reach_m` < 0: to the goal.
Value pathMessage(const Moment& moment, double reach_m);
Value footprintMessage(const Moment& moment);
Value laserScanMessage(const Moment& moment);
Value pointCloudMessage(const Moment& moment);
/// Markers as planners and operators' tools draw them: one of each common kind.
Value markersMessage(const Moment& moment);

}  // namespace mapwright::simulator::ros
