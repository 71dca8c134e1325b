// The live state of a robot, and the one reducer that builds it from topic messages, live or replayed
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

/// Everything known about the robot's world at present. Value type, cheap to copy since its large parts are
/// shared and immutable; submap::SubmapStore handles submap lists.
/// Coordinates are those of a frame, which changes with the SLAM session (the uuid of the submap list) and
/// with the map (the uid in MapInfo, or its name if there is no uid). Everything with coordinates in the old
/// frame is then dropped: the pose and the trail, pictures, points, paths, targets, landmarks, doors, boxes,
/// other robots, constraints, and the positions reported by localization and barcodes. The rest stays:
/// footprints, SLAM and planner states, alerts, battery, wheels, sensors. The picture of the whole map and
/// MapInfo belong to the map: they stay if a new session localizes in the same map.
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
  std::optional<JackState> jack;
  std::optional<TowingState> towing;
  std::vector<NearbyRobot> nearby_robots;
  std::map<std::string, Polyline> nearby_footprints;
  std::vector<Landmark> landmarks;
  std::vector<AutoDoor> doors;
  std::vector<GroundBox> pallets, racks, seen_objects;
  std::map<BoxKind, std::vector<GroundBox>> features;
  std::vector<GroundDrawing> drawings;
  ConstraintsMessage constraints;
  std::optional<GlobalPositioning> global_positioning;
  std::optional<BarcodeMessage> barcode;
  std::vector<SafetyCondition>
      safety;  // with times, including what ended a moment ago; read it with safetyOf()

  static constexpr double kTrailStepM = 0.05;
  static constexpr std::size_t kTrailPoints = 20'000;

  /// Compares everything visible: clouds and pictures by content, wherever they are stored; not the number of
  /// frames.
  bool operator==(const LiveState& other) const;
};

/// All boxes on the ground in the order in which they are drawn; `topic` is that of map::topicIndex.
struct BoxGroup {
  BoxKind kind = BoxKind::Object;
  int topic = 0;
  const std::vector<GroundBox>* boxes = nullptr;  // in the state
};
std::vector<BoxGroup> boxGroups(const LiveState& state);

/// Without everything in the old frame; `map_stays`: the new frame belongs to the same map.
LiveState inNewFrame(LiveState state, bool map_stays);

/// The state after `message`, which arrived at `at_s` (seconds since the epoch; the bag's time in a replay).
/// Messages that are not part of the state leave it unchanged.
LiveState reduce(LiveState state, const TopicMessage& message, double at_s);

/// `message` adds nothing to `state`: nobody who looks at the state sees a difference. Times of alerts do not
/// count.
bool repeats(const LiveState& state, const TopicMessage& message);

/// A robot that appears to be faster was moved: its position jumped.
constexpr double kJumpM = 0.5, kJumpMPerS = 5;
bool isJump(const TrailPoint& before, const TrailPoint& after);

/// After such a pause and distance the robot may have taken any path.
constexpr double kUnheardM = 1, kUnheardS = 5;
/// No jump and no long pause.
bool isWayKnown(const TrailPoint& before, const TrailPoint& after);

}  // namespace mapwright::map
