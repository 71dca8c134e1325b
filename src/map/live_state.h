// The live world of a robot, and the one reducer that builds it from topic messages, live or replayed
// (docs/decisions/0012-one-reducer-makes-the-world.md).
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "geometry/pose.h"
#include "map/live_topics.h"
#include "map/safety.h"

namespace mapwright::map {

/// Where the robot was, and when.
struct TrailPoint {
  Eigen::Vector2d position_m{0, 0};
  double at_s = 0;  // seconds since the epoch
  bool operator==(const TrailPoint&) const = default;
};

/// What is known of the robot's world now. Value type, cheap to copy where it is large (shared, immutable
/// parts); submap lists are handled by submap::SubmapBook.
///
/// Coordinates are those of a frame: it begins anew with another SLAM session (the uuid of the submap list)
/// and with another map (the uid in MapInfo, or its name where there is no uid). What lies in the old frame
/// is then forgotten: the pose and the trail, pictures, points, paths, targets, the places of landmarks,
/// doors, boxes, other robots, constraints, and where positioning and barcodes said that the robot was. What
/// is no place is kept: the robot's shape and those of others, SLAM's and the planner's state, alerts,
/// battery, wheels, sensors. The picture of the whole map and MapInfo lie in the map: they outlive a new
/// session that works in that map (positioning), and no other.
struct LiveState {
  int frame = 0;  // counts the frames
  std::string session_uuid;
  std::optional<geometry::Pose2> robot_pose;
  std::deque<TrailPoint> trail;  // oldest first, points at least kTrailStepM apart, at most kTrailPoints
  RobotModel model;
  SlamStatus slam;
  std::map<GridKind, GridMessage> grids;  // the last picture of each kind
  std::map<std::string, std::shared_ptr<const std::vector<CloudPoint>>> clouds;  // by topic
  Polyline path, trajectory;
  LocalPathMessage local_path;
  std::optional<PlanningState> planning;
  std::optional<MapInfo> map_info;
  std::vector<Alert> alerts;  // active now, oldest first
  std::optional<BatteryState> battery;
  std::optional<WheelState> wheels;
  std::optional<SensorState> sensors;
  std::vector<NearbyRobot> nearby_robots;
  std::map<std::string, Polyline> nearby_footprints;
  std::vector<Landmark> landmarks;
  std::vector<AutoDoor> doors;
  std::vector<GroundBox> pallets, racks, seen_objects;
  std::vector<GroundDrawing> drawings;
  ConstraintsMessage constraints;
  std::optional<GlobalPositioning> global_positioning;
  std::optional<BarcodeMessage> barcode;
  std::vector<SafetyCondition> safety;  // with times, and what ended a moment ago; read it by safetyOf()

  static constexpr double kTrailStepM = 0.05;
  static constexpr std::size_t kTrailPoints = 20'000;

  /// All that can be seen: clouds and pictures by their content, wherever it lies; not how many frames there
  /// were.
  bool operator==(const LiveState& other) const;
};

/// Without all that lies in the frame of before; `map_stays`: the new one is of the same map.
LiveState inNewFrame(LiveState state, bool map_stays);

/// The state after `message`, which came at `at_s` (seconds since the epoch; the bag's time when replayed).
/// Messages that the state does not hold leave it as it is.
LiveState reduce(LiveState state, const TopicMessage& message, double at_s);

}  // namespace mapwright::map
