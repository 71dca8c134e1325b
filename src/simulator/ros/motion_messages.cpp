// Where the robot is, where it goes, and how its frames hang together.
#include <algorithm>
#include <cmath>

#include "simulator/json_shapes.h"
#include "simulator/ros/ros_messages.h"
#include "simulator/ros/shapes.h"

namespace mapwright::simulator::ros {
namespace {

constexpr double kGoalM = 40;  // one goal after the other, each so far
constexpr double kStepM = 0.25;

double remainingOf(const Moment& moment) {
  const double driven = moment.robot.drivenMetres();
  return kGoalM - (driven - kGoalM * std::floor(driven / kGoalM));
}

Value transformStamped(const Moment& moment, std::string_view parent, std::string_view child,
                       const geometry::Pose2& pose, double z_m = 0) {
  Value transform = transformOf(pose, z_m);
  const Value odd = poseOf(pose, moment.faults);
  if (moment.faults.nan_pose) transform.set("translation", odd["position"]);
  if (moment.faults.zero_quaternion) transform.set("rotation", odd["orientation"]);
  return Value::Object{{"header", headerOf(parent, moment.time_s, moment.dialect())},
                       {"child_frame_id", child},
                       {"transform", std::move(transform)}};
}

Value poseStamped(const Moment& moment, std::string_view frame, Value pose) {
  return Value::Object{{"header", headerOf(frame, moment.time_s, moment.dialect())},
                       {"pose", std::move(pose)}};
}

Value poseWithCovariance(const Moment& moment, const geometry::Pose2& pose, double variance) {
  Value::Float64s covariance(36, 0.0);
  covariance[0] = covariance[7] = covariance[35] = variance;
  return Value::Object{{"pose", poseOf(pose, moment.faults)}, {"covariance", std::move(covariance)}};
}

}  // namespace

geometry::Pose2 Moment::odomFromBase() const { return mapFromOdom(time_s).inverse() * pose; }

Value tfMessage(const Moment& moment) {
  Value::List transforms{transformStamped(moment, "map", "odom", mapFromOdom(moment.time_s)),
                         transformStamped(moment, "odom", "base_link", moment.odomFromBase())};
  if (moment.faults.tf_loop) transforms.push_back(transformStamped(moment, "base_link", "map", {}));
  return Value::Object{{"transforms", std::move(transforms)}};
}

Value tfStaticMessage(const Moment& moment) {
  // What is fixed stays right under every fault.
  const RosFaults none;
  const Moment sound{moment.robot, moment.options, none, 0, moment.pose};
  Value::List transforms{transformStamped(sound, "base_link", "laser", kBaseFromLaser, kLaserHeightM)};
  return Value::Object{{"transforms", std::move(transforms)}};
}

Value odometryMessage(const Moment& moment) {
  const Value twist = Value::Object{{"linear", xyz(kSpeedMPerS, 0, 0)}, {"angular", xyz(0, 0, 0)}};
  return Value::Object{{"header", headerOf("odom", moment.time_s, moment.dialect())},
                       {"child_frame_id", "base_link"},
                       {"pose", poseWithCovariance(moment, moment.odomFromBase(), 0.001)},
                       {"twist", Value::Object{{"twist", twist}, {"covariance", Value::Float64s(36, 0.0)}}}};
}

Value amclPoseMessage(const Moment& moment) {
  return Value::Object{{"header", headerOf("map", moment.time_s, moment.dialect())},
                       {"pose", poseWithCovariance(moment, moment.pose, 0.02)}};
}

Value goalMessage(const Moment& moment) {
  return poseStamped(moment, "map", poseOf(moment.robot.poseAhead(remainingOf(moment))));
}

Value pathMessage(const Moment& moment, double reach_m) {
  const bool is_local = reach_m >= 0;
  const double remaining = remainingOf(moment);
  const double end = is_local ? std::min(reach_m, remaining) : remaining;
  const std::string_view frame = is_local ? "odom" : "map";
  const geometry::Pose2 to_frame = is_local ? mapFromOdom(moment.time_s).inverse() : geometry::Pose2{};
  Value::List poses;
  for (double s = 0; s < end + kStepM; s += kStepM) {
    poses.push_back(poseStamped(moment, frame, poseOf(to_frame * moment.robot.poseAhead(std::min(s, end)))));
  }
  return Value::Object{{"header", headerOf(frame, moment.time_s, moment.dialect())},
                       {"poses", std::move(poses)}};
}

Value footprintMessage(const Moment& moment) {
  Value::List points;
  for (const Eigen::Vector2d& corner : cornersOf(moment.odomFromBase(), kLengthM, kWidthM)) {
    points.push_back(Value::Object{{"x", float32(corner.x())}, {"y", float32(corner.y())}, {"z", 0.0}});
  }
  return Value::Object{{"header", headerOf("odom", moment.time_s, moment.dialect())},
                       {"polygon", Value::Object{{"points", std::move(points)}}}};
}

}  // namespace mapwright::simulator::ros
