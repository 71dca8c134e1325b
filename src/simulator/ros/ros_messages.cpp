#include "simulator/ros/ros_messages.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "simulator/lidar.h"
#include "simulator/noise.h"

namespace mapwright::simulator::ros {
namespace {

constexpr double kSeqPerS = 50;
constexpr double kStepM = 0.25;
constexpr double kLengthM = 0.62, kWidthM = 0.46;                     // of the footprint
constexpr geometry::Pose2 kBaseFromLaser{0.18, 0, std::numbers::pi};  // backwards on the robot
constexpr double kLaserHeightM = 0.22;
constexpr int kRays = 720;
constexpr std::size_t kPointStep = 16;
constexpr std::size_t kMostNamed = 200;

enum MarkerType {
  kArrow = 0,
  kCube = 1,
  kSphere = 2,
  kCylinder = 3,
  kLineStrip = 4,
  kPointList = 8,
  kTextFacing = 9
};

Value transformStamped(const Moment& moment, std::string_view parent, std::string_view child,
                       const geometry::Pose2& pose, double z_m = 0) {
  const Value place = poseOf(pose, moment.faults, z_m);
  return moment.stamped(
      parent,
      {{"child_frame_id", child},
       {"transform", Value::Object{{"translation", place["position"]}, {"rotation", place["orientation"]}}}});
}

Value poseWithCovariance(const Moment& moment, const geometry::Pose2& pose, double variance) {
  Value::Float64s covariance(36, 0.0);
  covariance[0] = covariance[7] = covariance[35] = variance;
  return Value::Object{{"pose", poseOf(pose, moment.faults)}, {"covariance", std::move(covariance)}};
}

/// Where the lidar truly is, whatever the robot believes.
geometry::Pose2 laserPose(const Moment& moment) {
  return moment.robot.misplacement().inverse() * moment.pose * kBaseFromLaser;
}

std::uint64_t scanSeed(const Moment& moment) {
  return hashOf(moment.options.seed, 101, static_cast<std::int64_t>(std::floor(moment.time_s * 10)));
}

Value marker(const Moment& moment, std::string_view ns, std::size_t id, MarkerType type, Value pose,
             Value scale) {
  const Value duration = moment.dialect() == RosDialect::Ros1 ? Value::Object{{"secs", 0}, {"nsecs", 0}}
                                                              : Value::Object{{"sec", 0}, {"nanosec", 0}};
  const Value colour =
      Value::Object{{"r", float32(0.1)}, {"g", float32(0.5)}, {"b", float32(0.9)}, {"a", float32(0.8)}};
  return moment.stamped("map", {{"ns", ns},
                                {"id", id},
                                {"type", static_cast<int>(type)},
                                {"action", 0},
                                {"pose", std::move(pose)},
                                {"scale", std::move(scale)},
                                {"color", colour},
                                {"lifetime", duration},
                                {"frame_locked", false},
                                {"points", Value::List{}},
                                {"colors", Value::List{}},
                                {"text", ""},
                                {"mesh_resource", ""},
                                {"mesh_use_embedded_materials", false}});
}

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
  if (dialect == RosDialect::Ros1)
    header.set("seq", static_cast<std::int64_t>(std::fmod(simulated_s * kSeqPerS, 4e9)));
  return header;
}

Value xyz(double x, double y, double z) { return Value::Object{{"x", x}, {"y", y}, {"z", z}}; }

Value quaternion(double z, double w) { return Value::Object{{"x", 0.0}, {"y", 0.0}, {"z", z}, {"w", w}}; }

Value poseOf(const geometry::Pose2& pose, double z_m) {
  static const RosFaults none;
  return poseOf(pose, none, z_m);
}

Value poseOf(const geometry::Pose2& pose, const RosFaults& faults, double z_m) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  return Value::Object{{"position", faults.nan_pose ? xyz(kNan, kNan, 0) : xyz(pose.x_m, pose.y_m, z_m)},
                       {"orientation", faults.zero_quaternion ? quaternion(0, 0)
                                                              : quaternion(std::sin(pose.yaw_rad / 2),
                                                                           std::cos(pose.yaw_rad / 2))}};
}

Value mapInfo(double resolution_m, int width, int height, const geometry::Pose2& origin, RosDialect dialect) {
  return Value::Object{{"map_load_time", timeOf(0, dialect)},
                       {"resolution", float32(resolution_m)},
                       {"width", width},
                       {"height", height},
                       {"origin", poseOf(origin)}};
}

geometry::Pose2 mapFromOdom(double simulated_s) {
  return {0.8 + 0.2 * std::sin(simulated_s / 60), -0.4 + 0.1 * std::cos(simulated_s / 37),
          0.1 + 0.02 * std::sin(simulated_s / 45)};
}

Value Moment::stamped(std::string_view frame, Value::Object members) const {
  members.emplace(members.begin(), "header", headerOf(frame, time_s, dialect()));
  return members;
}

Value tfMessage(const Moment& moment) {
  Value::List transforms{transformStamped(moment, "map", "odom", mapFromOdom(moment.time_s)),
                         transformStamped(moment, "odom", "base_link", moment.odomFromBase())};
  if (moment.faults.tf_loop) transforms.push_back(transformStamped(moment, "base_link", "map", {}));
  return Value::Object{{"transforms", std::move(transforms)}};
}

Value tfStaticMessage(const Moment& moment) {
  // What is fixed stays right under every fault.
  const RosFaults none;
  const Moment sound{moment.robot, moment.kabam, moment.pictures, moment.costs, moment.options, none, 0,
                     moment.pose};
  Value::List transforms{transformStamped(sound, "base_link", "laser", kBaseFromLaser, kLaserHeightM)};
  return Value::Object{{"transforms", std::move(transforms)}};
}

Value odometryMessage(const Moment& moment) {
  const Value twist = Value::Object{{"linear", xyz(kSpeedMPerS, 0, 0)}, {"angular", xyz(0, 0, 0)}};
  return moment.stamped(
      "odom", {{"child_frame_id", "base_link"},
               {"pose", poseWithCovariance(moment, moment.odomFromBase(), 0.001)},
               {"twist", Value::Object{{"twist", twist}, {"covariance", Value::Float64s(36, 0.0)}}}});
}

Value amclPoseMessage(const Moment& moment) {
  return moment.stamped("map", {{"pose", poseWithCovariance(moment, moment.pose, 0.02)}});
}

Value goalMessage(const Moment& moment) {
  return moment.stamped("map", {{"pose", poseOf(moment.robot.poseAhead(moment.robot.metresToGoal()))}});
}

Value pathMessage(const Moment& moment, double reach_m) {
  const bool is_local = reach_m >= 0;
  const double remaining = moment.robot.metresToGoal();
  const double end = is_local ? std::min(reach_m, remaining) : remaining;
  const std::string_view frame = is_local ? "odom" : "map";
  const geometry::Pose2 to_frame = is_local ? mapFromOdom(moment.time_s).inverse() : geometry::Pose2{};
  Value::List poses;
  for (double s = 0; s < end + kStepM; s += kStepM) {
    const Value pose = poseOf(to_frame * moment.robot.poseAhead(std::min(s, end)));
    poses.push_back(moment.stamped(frame, {{"pose", pose}}));
  }
  return moment.stamped(frame, {{"poses", std::move(poses)}});
}

Value footprintMessage(const Moment& moment) {
  Value::List points;
  for (const Eigen::Vector2d& corner : cornersOf(moment.odomFromBase(), kLengthM, kWidthM)) {
    points.push_back(Value::Object{{"x", float32(corner.x())}, {"y", float32(corner.y())}, {"z", 0.0}});
  }
  return moment.stamped("odom", {{"polygon", Value::Object{{"points", std::move(points)}}}});
}

Value laserScanMessage(const Moment& moment) {
  constexpr double kStep = 2 * std::numbers::pi / kRays;
  geometry::Pose2 pose = laserPose(moment);
  pose.yaw_rad -= std::numbers::pi;  // the first ray looks back
  const std::vector<double> found = rangesFrom(moment.robot.plan(), pose, kRays, scanSeed(moment));
  Value::Float32s ranges(found.begin(), found.end()), intensities;
  for (const double range : found) {
    intensities.push_back(std::isfinite(range) ? static_cast<float>(40 + 200 * std::exp(-range / 8)) : 0.0F);
  }
  return moment.stamped("laser", {{"angle_min", float32(-std::numbers::pi)},
                                  {"angle_max", float32(std::numbers::pi - kStep)},
                                  {"angle_increment", float32(kStep)},
                                  {"time_increment", 0.0},
                                  {"scan_time", float32(0.1)},
                                  {"range_min", float32(0.05)},
                                  {"range_max", float32(kLidarRangeM)},
                                  {"ranges", std::move(ranges)},
                                  {"intensities", std::move(intensities)}});
}

Value pointCloudMessage(const Moment& moment) {
  const bool big_endian = moment.faults.big_endian_cloud;
  const geometry::Pose2 laser = laserPose(moment), to_laser = laser.inverse();
  const std::vector<LidarPoint> points =
      scanFrom(moment.robot.plan(), laser, moment.options.points_per_scan, scanSeed(moment));
  std::string data;
  data.reserve(points.size() * kPointStep);
  for (const LidarPoint& point : points) {
    const Eigen::Vector2d at = to_laser.apply(point.at_m);
    for (const float number : {static_cast<float>(at.x()), static_cast<float>(at.y()),
                               point.z_m - static_cast<float>(kLaserHeightM), float(point.intensity)})
      appendNumber(data, number, big_endian);
  }
  Value::List fields;
  for (const char* name : {"x", "y", "z", "intensity"}) {
    fields.push_back(
        Value::Object{{"name", name}, {"offset", 4 * fields.size()}, {"datatype", 7}, {"count", 1}});
  }
  return moment.stamped("laser", {{"height", 1},
                                  {"width", points.size()},
                                  {"fields", std::move(fields)},
                                  {"is_bigendian", big_endian},
                                  {"point_step", kPointStep},
                                  {"row_step", data.size()},
                                  {"data", Value::Bytes{std::move(data)}},
                                  {"is_dense", true}});
}

Value markersMessage(const Moment& moment) {
  // Where the manager tells of waypoints, nobody else needs to.
  const std::optional<KabamMap> map = moment.options.ros.kabam ? std::nullopt : moment.kabam.current();
  Value::List markers;
  const auto add = [&](std::string_view ns, std::size_t id, MarkerType type, const Value& pose,
                       const Value& scale) -> Value& {
    markers.push_back(marker(moment, ns, id, type, pose, scale));
    return markers.back();
  };
  for (std::size_t i = 0; map && i < std::min(map->waypoints.size(), kMostNamed); ++i) {
    const KabamWaypoint& waypoint = map->waypoints[i];
    add("waypoints", 2 * i, kArrow, waypoint.pose, xyz(0.6, 0.1, 0.1));
    add("waypoints", 2 * i + 1, kTextFacing, waypoint.pose, xyz(0, 0, 0.3)).set("text", waypoint.name);
  }
  Value::List points;
  for (double s = 0; s <= 6; s += 0.5) {
    const geometry::Pose2 at = moment.robot.poseAhead(s);
    points.push_back(xyz(at.x_m, at.y_m, 0));
  }
  const Value ahead = poseOf(moment.robot.poseAhead(6)), here = poseOf(geometry::Pose2{});
  add("plan", 2, kArrow, ahead, xyz(0.6, 0.1, 0.1));
  add("plan", 3, kTextFacing, ahead, xyz(0, 0, 0.3)).set("text", "6 m ahead");
  add("plan", 0, kLineStrip, here, xyz(0.05, 0, 0)).set("points", points);
  add("plan", 1, kPointList, here, xyz(0.1, 0.1, 0)).set("points", points);
  const geometry::Pose2 beside = moment.pose * geometry::Pose2{1.5, 1, 0.4};
  add("people", 0, kCylinder, poseOf(beside, 0.85), xyz(0.5, 0.5, 1.7));
  add("people", 1, kSphere, poseOf(beside, 1.8), xyz(0.3, 0.3, 0.3));
  const geometry::Pose2 behind = moment.pose * geometry::Pose2{-1.5, -0.5, 0.2};
  add("crates", 0, kCube, poseOf(behind, 0.3), xyz(0.6, 0.4, 0.6));
  return Value::Object{{"markers", std::move(markers)}};
}

}  // namespace mapwright::simulator::ros
