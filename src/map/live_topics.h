// Messages of a robot about its world, as typed values: one struct per topic shown on the map or in the
// status panel. Source: docs/protocols/autoxing.md, "Topics that the map shows". World metres and radians;
// texts are untrusted.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "geometry/pose.h"
#include "map/catalogue.h"
#include "map/grid_reference.h"
#include "map/overlay.h"
#include "map/submap.h"

namespace mapwright::map {

using Polyline = std::vector<Eigen::Vector2d>;

/// /tracked_pose: pos [x,y] metres, ori radians.
struct TrackedPose {
  geometry::Pose2 pose;
  bool operator==(const TrackedPose&) const = default;
};

/// /robot_model: outlines in the robot frame, metres. Empty when unknown.
struct RobotModel {
  Polyline footprint, expanded_footprint;
  double width_m = 0;
  bool operator==(const RobotModel&) const = default;
};

/// /slam/state.
struct SlamStatus {
  std::string state;  // inactive, slam, positioning, or anything else that the robot reports
  std::optional<bool> reliable;
  std::optional<int> position_quality;  // 0 unknown, 1 lost, 3 poor, 8 good, 10 excellent
  std::optional<double> lidar_matching_score;
  std::optional<bool> lidar_matched, wheel_slipping;
  bool operator==(const SlamStatus&) const = default;
};

/// The raster layer of a picture.
enum class GridKind {
  WholeMap,     // /map, /map_v2
  CostmapLow,   // /maps/5cm/1hz, /map/costmap, /map/costmap_v2
  CostmapHigh,  // /maps/1cm/1hz
  Incremental,  // /incremental_map, /incremental_map_v2
  EnvMatch,     // /env_match_map
  EnvSymmetry,  // /env_symmetry_map
};

/// A picture topic with the picture itself (base64 decoded, or fetched from data_url).
struct GridMessage {
  std::string topic;
  GridKind kind = GridKind::WholeMap;
  GridReference grid;
  CellReading reading;  // the meaning of its bytes; anything but Picture: occupancy 0..100 and unknown
  std::shared_ptr<const std::string> png;  // the picture file; also PGM and BMP
  std::string fingerprint;                 // identifies exactly this content; empty = none
  std::size_t body_bytes = 0;              // of the answer with the picture; 0 = it was inside the message
  bool from_cache = false;                 // nothing was transferred: disk cache, or 304
  bool operator==(const GridMessage& other) const;  // compares the bytes, wherever they are stored
};

struct CloudPoint {
  double x_m = 0, y_m = 0;
  float z_m = 0;
  std::uint8_t intensity = 0;  // 0..255, 0 if the robot sends none
  bool operator==(const CloudPoint&) const = default;
};

/// Lidar points in the world frame: /scan_matched_points2, /..._laser_2d/matched, /semantic_points,
/// /matched_depth_points/..., binary clouds. Immutable once made.
struct PointCloudMessage {
  std::string topic;
  std::shared_ptr<const std::vector<CloudPoint>> points;
  bool operator==(const PointCloudMessage& other) const;  // compares the points, wherever they are stored
};

/// /path: the global path.
struct PathMessage {
  Polyline points;
  bool operator==(const PathMessage&) const = default;
};

/// /local_path. `rgba` 0xRRGGBBAA if the robot gives a colour.
struct LocalPathMessage {
  double width_m = 0;
  std::optional<std::uint32_t> rgba;
  Polyline points;
  bool operator==(const LocalPathMessage&) const = default;
};

/// /trajectory (old firmware: /trajectory_node_list).
struct TrajectoryMessage {
  Polyline points;
  bool operator==(const TrajectoryMessage&) const = default;
};

/// /planning_state.
struct PlanningState {
  std::optional<std::int64_t> action_id;
  std::string action_type, move_state, fail_reason, stuck_state;
  std::optional<double> remaining_distance_m;
  std::vector<geometry::Pose2> targets;
  bool operator==(const PlanningState&) const = default;
};

/// /map/info. Overlays as drawn; the raw text is kept for editing.
struct MapInfo {
  std::string name, uid;
  std::optional<int> map_version, overlays_version;
  std::vector<OverlayFeature> overlays;
  std::vector<BrokenOverlay> broken_overlays = {};  // left out of them
  bool operator==(const MapInfo&) const = default;
};

enum class AlertLevel { None, Warning, Error };
struct Alert {
  std::int64_t code = 0;
  AlertLevel level = AlertLevel::None;
  std::string text;
  double since_s = 0;  // when it first arrived (seconds since the epoch); set by the reducer
  bool operator==(const Alert&) const = default;
};
/// /alerts: all active alerts.
struct AlertsMessage {
  std::vector<Alert> alerts;
  bool operator==(const AlertsMessage&) const = default;
};

/// /battery_state, /detailed_battery_state. `level` 0..1.
struct BatteryState {
  std::optional<double> level, voltage_v, current_a;
  std::string supply;  // charging, discharging, full
  bool operator==(const BatteryState&) const = default;
};

/// /wheel_state.
struct WheelState {
  std::string control_mode;  // auto, remote, manual
  std::optional<bool> emergency_stop, wheels_released;
  bool operator==(const WheelState&) const = default;
};

/// /sensor_manager_state.
struct SensorState {
  std::string power_state;
  bool operator==(const SensorState&) const = default;
};

/// /jack_state.
struct JackState {
  std::string state;               // hold, jacking_up, jacking_down, unknown
  std::optional<double> progress;  // 0 down .. 1 up
  std::optional<bool> self_checking;
  std::optional<double> weight;  // on it, in the robot's own unit
  bool operator==(const JackState&) const = default;
};

/// /towing_state: the lock that holds a cart.
struct TowingState {
  std::string state;               // locked, released, locking, releasing, self_checking, error, unknown
  std::optional<double> progress;  // of the action, 0..1
  std::optional<bool> cargo_detected;
  std::int64_t error_code = 0;  // 0 = none
  std::string error = {};
  bool operator==(const TowingState&) const = default;
};

struct NearbyRobot {
  std::string uid;
  geometry::Pose2 pose;
  Polyline trend;
  std::string footprint_digest;
  bool operator==(const NearbyRobot&) const = default;
};
/// /nearby_robots and /nearby_robot_footprints.
struct NearbyRobotsMessage {
  std::vector<NearbyRobot> robots;
  bool operator==(const NearbyRobotsMessage&) const = default;
};
struct NearbyFootprintsMessage {
  std::map<std::string, Polyline> by_digest;  // robot frame
  bool operator==(const NearbyFootprintsMessage&) const = default;
};

struct Landmark {
  std::string id;
  Eigen::Vector2d position_m{0, 0};
  std::optional<bool> in_use;
  bool operator==(const Landmark&) const = default;
};
struct LandmarksMessage {
  std::vector<Landmark> landmarks;
  bool operator==(const LandmarksMessage&) const = default;
};

struct AutoDoor {
  std::string name, mac, state;
  Polyline polygon;
  bool operator==(const AutoDoor&) const = default;
};
struct AutoDoorsMessage {
  std::vector<AutoDoor> doors;
  bool operator==(const AutoDoorsMessage&) const = default;
};

/// A box on the ground: a pallet, a rack, a seen object. `in_robot_frame`: pose is relative to the robot.
struct GroundBox {
  std::string label;
  geometry::Pose2 pose;
  double length_m = 0;  // along the pose's x axis
  double width_m = 0;
  bool in_robot_frame = false;
  std::optional<std::uint32_t> rgba = {};  // 0xRRGGBBAA if the robot gives a colour
  bool operator==(const GroundBox&) const = default;
};
/// Something that a robot draws without saying what it is (a ROS marker), flat on the ground.
struct GroundDrawing {
  enum class Kind {
    Line,
    Segments,   // each two points
    Triangles,  // each three points, filled
    Points,
    Text,  // at its one point
  };
  Kind kind = Kind::Line;
  Polyline points;
  double size_m = 0;  // width of a line, edge of a point, height of a text; 0 = as small as visible
  std::optional<std::uint32_t> rgba = {};  // 0xRRGGBBAA if the robot gives a colour
  std::vector<std::uint32_t> colors = {};  // one per point, or none
  std::string text = {};
  bool operator==(const GroundDrawing&) const = default;
};
enum class BoxKind { Pallet, Rack, Charger, Object };
/// /detected_features/racks_v2, /pallets, /chargers: all of one kind. Those without a size have length and
/// width 0.
struct DetectedFeaturesMessage {
  BoxKind kind = BoxKind::Rack;
  std::vector<GroundBox> boxes;
  bool operator==(const DetectedFeaturesMessage&) const = default;
};
struct PalletsMessage {
  std::vector<GroundBox> pallets;
  bool operator==(const PalletsMessage&) const = default;
};
/// /detected_rack: none, or the box (aligned one last).
struct RackMessage {
  std::vector<GroundBox> racks;
  bool operator==(const RackMessage&) const = default;
};
struct SeenObjectsMessage {  // /vision_detected_objects; markers of ROS
  std::vector<GroundBox> objects;
  std::vector<GroundDrawing> drawings = {};
  bool operator==(const SeenObjectsMessage&) const = default;
};

/// /constraint_list: segments by kind ("Inter residuals, different trajectories").
struct ConstraintsMessage {
  std::map<std::string, std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>>> by_name;
  bool operator==(const ConstraintsMessage&) const = default;
};

/// /global_positioning_state.
struct GlobalPositioning {
  std::string state, message;
  std::optional<double> score;
  std::optional<bool> needs_confirmation;
  std::optional<geometry::Pose2> pose;
  bool operator==(const GlobalPositioning&) const = default;
};

/// /collected_barcode.
struct BarcodeMessage {
  std::string state, id;
  std::optional<geometry::Pose2> pose;
  bool operator==(const BarcodeMessage&) const = default;
};

/// A message that could not be read, for the list of problems.
struct UnreadableMessage {
  std::string topic;
  Fault reason;
  bool operator==(const UnreadableMessage&) const = default;
};

using TopicMessage =
    std::variant<SubmapList, TrackedPose, RobotModel, SlamStatus, GridMessage, PointCloudMessage, PathMessage,
                 LocalPathMessage, TrajectoryMessage, PlanningState, MapInfo, AlertsMessage, BatteryState,
                 WheelState, SensorState, JackState, TowingState, NearbyRobotsMessage,
                 NearbyFootprintsMessage, LandmarksMessage, AutoDoorsMessage, DetectedFeaturesMessage,
                 PalletsMessage, RackMessage, SeenObjectsMessage, ConstraintsMessage, GlobalPositioning,
                 BarcodeMessage, UnreadableMessage>;

/// The index of a message type in TopicMessage.
template <typename T, std::size_t I = 0>
constexpr int topicIndex() {
  if constexpr (std::is_same_v<std::variant_alternative_t<I, TopicMessage>, T>) {
    return int(I);
  } else {
    return topicIndex<T, I + 1>();
  }
}

/// Seconds since the epoch.
struct StampedMessage {
  TopicMessage message;
  double received_s = 0;                  // when it arrived here, or at the recorder
  std::optional<double> recorded_s = {};  // the robot's own time stamp; nullopt = none
  std::string topic = {};                 // the robot's name for it, for display; empty = not displayed

  /// The time used for the world. A robot's clock may be wrong by years, while the time of arrival is always
  /// known, so that one is used.
  double at_s() const { return received_s; }
  bool operator==(const StampedMessage&) const = default;
};

}  // namespace mapwright::map
