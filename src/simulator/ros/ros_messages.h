// The topics of the simulated ROS robot: functions of the robot's clock, maps and faults.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "simulator/cost_maps.h"
#include "simulator/fault_plan.h"
#include "simulator/ros/kabam_store.h"
#include "simulator/value.h"

namespace mapwright::simulator::ros {

/// The input for all messages at one time.
struct Moment {
  const RobotState& robot;
  const Options& options;
  const RosFaults& faults;
  double time_s = 0;
  geometry::Pose2 pose;  // of base_link in map

  RosDialect dialect() const { return options.ros.dialect; }
  geometry::Pose2 odomFromBase() const;
};

// motion_messages.cpp
Value tfMessage(const Moment& moment);
Value tfStaticMessage(const Moment& moment);
Value odometryMessage(const Moment& moment);
Value amclPoseMessage(const Moment& moment);
Value goalMessage(const Moment& moment);
/// From the robot on; `reach_m` < 0: to the goal.
Value pathMessage(const Moment& moment, double reach_m);
Value footprintMessage(const Moment& moment);

// sensor_messages.cpp
Value laserScanMessage(const Moment& moment);
Value pointCloudMessage(const Moment& moment);

// marker_messages.cpp
Value markersMessage(const Moment& moment, const std::optional<KabamMap>& map);

// grid_messages.cpp
/// Occupancy, row 0 at the bottom.
struct OccupancyCells {
  GridPlace place;
  Value::Int8s cells;
};
OccupancyCells occupancyOf(const FloorCells& floor, const GrayPicture* image);
OccupancyCells occupancyOf(const GrayPicture& costs, const GridPlace& place);
/// The part of `of` within `reach_m` of a point; empty if there is none.
Value gridPatchMessage(const Moment& moment, std::string_view frame, const OccupancyCells& of,
                       const Eigen::Vector2d& around_m, double reach_m);
Value gridMessage(const Moment& moment, std::string_view frame, OccupancyCells grid);

/// Safe from any thread: slow topics are made by workers.
class Messages {
 public:
  Messages(const RobotState& robot, const Options& options, const FaultPlan& faults, KabamStore& kabam,
           MapPictures& pictures)
      : robot_(robot), options_(options), faults_(faults), kabam_(kabam), pictures_(pictures) {}

  /// nullopt if there is nothing to send: no map, nothing that grows.
  std::optional<Value> messageOf(std::string_view topic);
  /// What nav_msgs/GetMap answers.
  std::optional<Value> mapMessage();

 private:
  struct KeptCosts {
    RasterSource source;
    std::shared_ptr<const OccupancyCells> grid;
  };
  std::optional<Value> gridTopic(std::string_view topic, const Moment& moment);
  std::optional<Value> kabamTopic(std::string_view topic) const;
  std::shared_ptr<const OccupancyCells> costsOfMap();
  std::optional<OccupancyCells> mapCells();
  Moment momentOf(const RosFaults& faults) const;

  const RobotState& robot_;
  const Options& options_;
  const FaultPlan& faults_;
  KabamStore& kabam_;
  MapPictures& pictures_;
  std::mutex mutex_;
  std::optional<KeptCosts> costs_;
};

/// The waypoint with the effects of the faults: the `index`th has the invalid pose.
Value shownWaypoint(const KabamWaypoint& waypoint, std::string_view map_id, std::size_t index,
                    const RosFaults& faults);
/// kabam_msgs/MapWaypointList.
Value waypointList(const KabamMap& map, const RosFaults& faults);

}  // namespace mapwright::simulator::ros
