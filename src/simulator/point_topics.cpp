#include "simulator/point_topics.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "ros_messages/wrapper.pb.h"
#include "simulator/json_text.h"
#include "simulator/lidar.h"
#include "simulator/noise.h"
#include "simulator/png_writing.h"
#include "simulator/simulator.h"
#include "simulator/stamp.h"

namespace mapwright::simulator {
namespace {

constexpr int kLargeScan = 5000;
constexpr std::int64_t kPrepared = 8;
constexpr std::size_t kMostKept = 64;
constexpr int kMostPoints = 1'000'000;
constexpr float kBinaryResolutionM = 0.001F;
constexpr std::string_view kMatchedPoints = "/scan_matched_points2", kPacked = "/left_laser_2d/matched",
                           kSemantic = "/semantic_points";

std::string header(std::string_view topic, double time_s) {
  std::string out = "{\"topic\":";
  appendJsonText(out, topic);
  // Milliseconds here, as these robots have it; seconds in most other topics.
  out += ",\"stamp\":" + std::to_string(std::llround(1000 * stampOf(time_s)));
  return out;
}

std::string pointsJson(const std::vector<LidarPoint>& points, double time_s) {
  std::string out = header(kMatchedPoints, time_s);
  out.reserve(out.size() + points.size() * 24);
  out += ",\"points\":[";
  bool first = true;
  for (const LidarPoint& point : points) {
    out += first ? "[" : ",[";
    first = false;
    appendJsonFixed(out, point.at_m.x(), 3);
    out += ',';
    appendJsonFixed(out, point.at_m.y(), 3);
    out += ',';
    appendJsonFixed(out, static_cast<double>(point.z_m), 2);
    out += ']';
  }
  return out + "]}";
}

void appendFloat(std::string& bytes, double value) {
  const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
  for (const int shift : {0, 8, 16, 24}) bytes += static_cast<char>((bits >> shift) & 0xFF);
}

std::string packedJson(const std::vector<LidarPoint>& points, double time_s) {
  std::string bytes;
  bytes.reserve(points.size() * 16);
  for (const LidarPoint& point : points) {
    appendFloat(bytes, point.at_m.x());
    appendFloat(bytes, point.at_m.y());
    appendFloat(bytes, static_cast<double>(point.z_m));
    appendFloat(bytes, point.intensity / 255.0);
  }
  return header(kPacked, time_s) +
         R"(,"fields":[{"name":"x","data_type":"f32"},{"name":"y","data_type":"f32"},{"name":"z","data_type":"f32"},)"
         R"({"name":"intensity","data_type":"f32"}],"data":")" +
         base64(bytes) + "\"}";
}

/// Every fourth point belongs to somebody who walks by: less likely, with a heading and a speed.
std::string semanticJson(const std::vector<LidarPoint>& points, double time_s) {
  std::string bytes;
  bytes.reserve(points.size() * 15);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool moves = i % 4 == 0;
    appendFloat(bytes, points[i].at_m.x());
    appendFloat(bytes, points[i].at_m.y());
    appendFloat(bytes, static_cast<double>(points[i].z_m));
    bytes += static_cast<char>(moves ? 90 : 240);
    bytes += static_cast<char>(moves ? 64 : 0);
    bytes += static_cast<char>(moves ? 80 : 0);
  }
  return header(kSemantic, time_s) +
         R"(,"fields":[{"name":"x","data_type":"f32"},{"name":"y","data_type":"f32"},{"name":"z","data_type":"f32"},)"
         R"({"name":"probability","data_type":"u8"},{"name":"ori","data_type":"u8"},{"name":"speed","data_type":"u8"}],)"
         R"("data":")" +
         base64(bytes) + "\"}";
}

std::string pointsBinary(const std::vector<LidarPoint>& points, const geometry::Pose2& robot,
                         std::int64_t number, double time_s) {
  ros_messages::RosMessageWrapper wrapper;
  wrapper.set_type(ros_messages::POINT_CLOUD);
  ros_messages::PointCloud& cloud = *wrapper.mutable_point_cloud();
  const double stamp = stampOf(time_s);
  cloud.mutable_header()->set_seq(static_cast<std::uint32_t>(number & 0xFFFFFFFF));
  cloud.mutable_header()->set_stamp_sec(static_cast<std::uint64_t>(stamp));
  cloud.mutable_header()->set_stamp_nsec(
      static_cast<std::uint64_t>(1e6 * std::floor(1e3 * (stamp - std::floor(stamp)))));
  cloud.mutable_header()->set_frame_id("map");
  cloud.set_point_number(static_cast<std::uint32_t>(points.size()));
  const Eigen::Vector2d centre(std::round(robot.x_m), std::round(robot.y_m));
  cloud.set_center_x(centre.x());
  cloud.set_center_y(centre.y());
  cloud.set_resolution(kBinaryResolutionM);
  cloud.set_is_delta_encoded(true);
  const auto cells = [](double metres) {
    return static_cast<std::int32_t>(std::lround(metres / static_cast<double>(kBinaryResolutionM)));
  };
  std::int32_t x = 0, y = 0, z = 0;
  std::string intensities;
  for (const LidarPoint& point : points) {
    const std::int32_t px = cells(point.at_m.x() - centre.x()), py = cells(point.at_m.y() - centre.y()),
                       pz = cells(static_cast<double>(point.z_m));
    cloud.add_xs(px - x);
    cloud.add_ys(py - y);
    cloud.add_zs(pz - z);
    x = px;
    y = py;
    z = pz;
    intensities += static_cast<char>(point.intensity);
  }
  cloud.set_intensities(intensities);
  return binaryMessage(kMatchedPoints, wrapper);
}

/// What the lidar sees from where the robot is, put where it believes to be.
std::vector<LidarPoint> pointsNow(const RobotState& state, int count, std::uint64_t seed) {
  const geometry::Pose2 misplacement = state.misplacement();
  std::vector<LidarPoint> points =
      scanFrom(state.plan(), misplacement.inverse() * state.robotPose(), count, seed);
  for (LidarPoint& point : points) point.at_m = misplacement.apply(point.at_m);
  return points;
}

}  // namespace

std::string scanMessage(const RobotState& state, int points, std::uint32_t seed) {
  const double time_s = state.time();
  return pointsJson(
      pointsNow(state, std::min(points, kMostPoints), hashOf(seed, 97, std::llround(1000 * time_s))), time_s);
}

std::optional<Frame> PointTopics::messageOf(std::string_view topic, bool binary) {
  if (topic != kMatchedPoints && topic != kPacked && topic != kSemantic) return std::nullopt;
  const bool as_binary = binary && topic == kMatchedPoints;
  const double hz = options_.scan_hz;
  const bool large = options_.points_per_scan > kLargeScan;
  auto number = static_cast<std::int64_t>(std::floor(state_.time() * hz));
  if (large) number %= kPrepared;

  const std::lock_guard lock(mutex_);
  const Key key{std::string(topic), as_binary, number};
  if (const auto found = made_.find(key); found != made_.end()) return found->second;
  if (made_.size() >= kMostKept) made_.clear();
  const geometry::Pose2 pose = state_.robotPose();
  const double time_s = state_.time();
  const std::vector<LidarPoint> points =
      pointsNow(state_, std::min(options_.points_per_scan, kMostPoints), hashOf(options_.seed, 97, number));
  Frame frame =
      as_binary ? Frame{std::make_shared<const std::string>(pointsBinary(points, pose, number, time_s)), true}
      : topic == kMatchedPoints ? textFrame(pointsJson(points, time_s))
      : topic == kPacked        ? textFrame(packedJson(points, time_s))
                                : textFrame(semanticJson(points, time_s));
  made_[key] = frame;
  return frame;
}

}  // namespace mapwright::simulator
