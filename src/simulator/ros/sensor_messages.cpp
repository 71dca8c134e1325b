// What the robot's lidar sees.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <numbers>

#include "simulator/lidar.h"
#include "simulator/noise.h"
#include "simulator/ros/ros_messages.h"
#include "simulator/ros/shapes.h"

namespace mapwright::simulator::ros {
namespace {

constexpr int kRays = 720;
constexpr std::size_t kPointStep = 16;

/// Where the lidar truly is, whatever the robot believes.
geometry::Pose2 laserPose(const Moment& moment) {
  return moment.robot.misplacement().inverse() * moment.pose * kBaseFromLaser;
}

std::uint64_t seedOf(const Moment& moment) {
  return hashOf(moment.options.seed, 101, static_cast<std::int64_t>(std::floor(moment.time_s * 10)));
}

void appendFloat(std::string& out, float number, bool big_endian) {
  const auto bits = std::bit_cast<std::uint32_t>(number);
  for (int i = 0; i < 4; ++i) out += static_cast<char>((bits >> (big_endian ? 24 - 8 * i : 8 * i)) & 0xFF);
}

}  // namespace

Value laserScanMessage(const Moment& moment) {
  constexpr double kStep = 2 * std::numbers::pi / kRays;
  geometry::Pose2 pose = laserPose(moment);
  pose.yaw_rad -= std::numbers::pi;  // the first ray looks back
  const std::vector<double> found = rangesFrom(moment.robot.plan(), pose, kRays, seedOf(moment));
  Value::Float32s ranges(found.begin(), found.end()), intensities;
  for (const double range : found) {
    intensities.push_back(std::isfinite(range) ? static_cast<float>(40 + 200 * std::exp(-range / 8)) : 0.0F);
  }
  return Value::Object{{"header", headerOf("laser", moment.time_s, moment.dialect())},
                       {"angle_min", float32(-std::numbers::pi)},
                       {"angle_max", float32(std::numbers::pi - kStep)},
                       {"angle_increment", float32(kStep)},
                       {"time_increment", 0.0},
                       {"scan_time", float32(0.1)},
                       {"range_min", float32(0.05)},
                       {"range_max", float32(kLidarRangeM)},
                       {"ranges", std::move(ranges)},
                       {"intensities", std::move(intensities)}};
}

Value pointCloudMessage(const Moment& moment) {
  const bool big_endian = moment.faults.big_endian_cloud;
  const geometry::Pose2 laser = laserPose(moment), to_laser = laser.inverse();
  const std::vector<LidarPoint> points =
      scanFrom(moment.robot.plan(), laser, moment.options.points_per_scan, seedOf(moment));
  std::string data;
  data.reserve(points.size() * kPointStep);
  for (const LidarPoint& point : points) {
    const Eigen::Vector2d at = to_laser.apply(point.at_m);
    appendFloat(data, static_cast<float>(at.x()), big_endian);
    appendFloat(data, static_cast<float>(at.y()), big_endian);
    appendFloat(data, point.z_m - static_cast<float>(kLaserHeightM), big_endian);
    appendFloat(data, point.intensity, big_endian);
  }
  Value::List fields;
  int offset = 0;
  for (const char* name : {"x", "y", "z", "intensity"}) {
    fields.push_back(Value::Object{{"name", name}, {"offset", offset}, {"datatype", 7}, {"count", 1}});
    offset += 4;
  }
  return Value::Object{{"header", headerOf("laser", moment.time_s, moment.dialect())},
                       {"height", 1},
                       {"width", points.size()},
                       {"fields", std::move(fields)},
                       {"is_bigendian", big_endian},
                       {"point_step", kPointStep},
                       {"row_step", data.size()},
                       {"data", Value::Bytes{std::move(data)}},
                       {"is_dense", true}};
}

}  // namespace mapwright::simulator::ros
