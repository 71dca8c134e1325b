#include "robot/ros/drawn_messages.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Eigenvalues>

#include "robot/ros/parts.h"

namespace mapwright::robot::ros {
namespace {

constexpr double kArrowM = 0.2;  // of a pose in a list
constexpr double kSpotM = 0.2;   // of a point
constexpr int kArcSteps = 16, kRingSteps = 48;
constexpr double kWithin95 = 2.4477;     // standard deviations in the plane
constexpr double kLargestSpreadM = 1e5;  // larger means unknown
constexpr std::size_t kMostDrawnCells = 100'000;

Eigen::Vector3d onGround(const Eigen::Vector2d& at) { return {at.x(), at.y(), 0}; }

Marker lineOf(const Outline& outline, bool closed) {
  Marker marker;
  marker.header = outline.header;
  marker.kind = Marker::Kind::LineStrip;
  for (const Eigen::Vector2d& point : outline.points) marker.points.push_back(onGround(point));
  if (closed && marker.points.size() > 1) marker.points.push_back(marker.points.front());
  return marker;
}

/// An arrow each.
Marker arrowsOf(const Poses& poses) {
  Marker marker;
  marker.header = poses.header;
  marker.kind = Marker::Kind::LineList;
  for (const geometry::Pose2& pose : poses.poses) {
    const auto at = [&](double ahead_m, double aside_m) {
      const geometry::Pose2 placed = pose * geometry::Pose2{ahead_m, aside_m, 0};
      return Eigen::Vector3d(placed.x_m, placed.y_m, 0);
    };
    const Eigen::Vector3d tip = at(kArrowM, 0);
    for (const Eigen::Vector3d& point :
         {at(0, 0), tip, tip, at(kArrowM * 0.7, kArrowM * 0.2), tip, at(kArrowM * 0.7, -kArrowM * 0.2)})
      marker.points.push_back(point);
  }
  return marker;
}

Read<Poses> readParticles(const Field& msg) {
  const Field list = msg["particles"];
  if (!list.isList()) return fieldMissing("particles");
  Poses all;
  all.header = headerOf(msg);
  const std::size_t stride = strideFor(list.size(), kMostPoses);
  std::size_t index = 0;
  list.each([&](const Field& item) {
    if (index++ % stride != 0) return;
    const geometry::Pose2 pose = poseOf(item["pose"]).pose.flat();
    if (std::isfinite(pose.x_m) && std::isfinite(pose.y_m)) all.poses.push_back(pose);
  });
  return all;
}

/// The cone that it looks into, as far as it measured. Along x of its frame.
Read<Marker> readRange(const Field& msg) {
  const auto range = msg["range"].number();
  const double angle = numberOr(msg["field_of_view"], 0);  // of a laser 0
  const double nearest = numberOr(msg["min_range"], 0), farthest = numberOr(msg["max_range"], 0);
  Marker marker;
  marker.header = headerOf(msg);
  marker.kind = Marker::Kind::LineStrip;
  if (!msg["field_of_view"].isNumber()) return fieldMissing("field_of_view");
  // Infinite, or null in JSON: nothing was hit.
  const bool hit = range && std::isfinite(*range) && *range > 0 && *range >= nearest &&
                   (farthest <= nearest || *range <= farthest);
  if (!hit) return marker;
  const double half = std::clamp(std::abs(angle), 0.0, 2 * std::numbers::pi) / 2;
  marker.points.emplace_back(0, 0, 0);
  for (int step = 0; step <= kArcSteps; ++step) {
    const double at = half * (2.0 * step / kArcSteps - 1);
    marker.points.emplace_back(*range * std::cos(at), *range * std::sin(at), 0);
  }
  marker.points.emplace_back(0, 0, 0);
  return marker;
}

Read<Marker> readGridCells(const Field& msg) {
  const Field list = msg["cells"];
  if (!list.isList()) return fieldMissing("cells");
  Marker marker;
  marker.header = headerOf(msg);
  marker.kind = Marker::Kind::CubeList;
  marker.scale_m = {numberOr(msg["cell_width"], 0), numberOr(msg["cell_height"], 0), 0};
  for (double& edge : marker.scale_m) edge = std::isfinite(edge) ? std::abs(edge) : 0;
  const std::size_t stride = strideFor(list.size(), kMostDrawnCells);
  std::size_t index = 0;
  list.each([&](const Field& item) {
    const Eigen::Vector2d at = pointOf(item).head<2>();
    if (index++ % stride == 0 && at.allFinite()) marker.points.push_back(onGround(at));
  });
  return marker;
}

Read<Marker> readPoint(const Field& msg, const std::string& name) {
  Marker marker;
  marker.header = headerOf(msg);
  marker.pose.t_m = pointOf(msg["point"]);
  if (std::isnan(marker.pose.t_m.z())) marker.pose.t_m.z() = 0;
  if (!marker.pose.t_m.allFinite()) return fieldMissing("point");
  marker.kind = Marker::Kind::Sphere;
  marker.scale_m = {kSpotM, kSpotM, kSpotM};
  marker.text = name;
  return marker;
}

/// Where it is by 95 %. Without usable numbers nothing.
Read<Marker> readSpread(const Field& msg) {
  const auto placed = readPoseWithCovariance(msg);
  if (!placed) return tl::unexpected(placed.error());
  Marker marker;
  marker.header = placed->header;
  marker.kind = Marker::Kind::LineStrip;
  const auto numbers = msg["pose"]["covariance"].numbers(36);
  if (!numbers || numbers->size() != 36) return fieldMissing("pose.covariance");
  const double xy = ((*numbers)[1] + (*numbers)[6]) / 2;
  Eigen::Matrix2d spread;
  spread << (*numbers)[0], xy, xy, (*numbers)[7];
  if (!spread.allFinite()) return marker;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread);
  const Eigen::Vector2d squares = axes.eigenvalues();
  const bool usable = squares.minCoeff() >= -1e-9 && squares.maxCoeff() > 0 &&
                      squares.maxCoeff() < kLargestSpreadM * kLargestSpreadM;
  if (!usable) return marker;
  const Eigen::Vector2d radii = squares.cwiseMax(0).cwiseSqrt() * kWithin95;
  for (int step = 0; step <= kRingSteps; ++step) {
    const double turn = 2 * std::numbers::pi * step / kRingSteps;
    const Eigen::Vector2d aside =
        axes.eigenvectors() * Eigen::Vector2d(radii.x() * std::cos(turn), radii.y() * std::sin(turn));
    marker.points.push_back(onGround({placed->pose.x_m + aside.x(), placed->pose.y_m + aside.y()}));
  }
  return marker;
}

Read<Marker> readOne(std::string_view type, const Field& msg, const std::string& name) {
  if (type == "nav_msgs/Path")
    return readPath(msg).map([](const Outline& line) { return lineOf(line, false); });
  if (type == "geometry_msgs/PolygonStamped")
    return readPolygon(msg).map([](const Outline& line) { return lineOf(line, true); });
  if (type == "geometry_msgs/PoseArray") return readPoseArray(msg).map(arrowsOf);
  if (type == "nav2_msgs/ParticleCloud") return readParticles(msg).map(arrowsOf);
  if (type == "sensor_msgs/Range") return readRange(msg);
  if (type == "nav_msgs/GridCells") return readGridCells(msg);
  if (type == "geometry_msgs/PointStamped") return readPoint(msg, name);
  return readSpread(msg);
}

}  // namespace

const std::vector<std::string>& drawnTypes() {
  static const std::vector<std::string> types{"nav_msgs/Path",
                                              "geometry_msgs/PolygonStamped",
                                              "geometry_msgs/PoseArray",
                                              "nav2_msgs/ParticleCloud",
                                              "sensor_msgs/Range",
                                              "nav_msgs/GridCells",
                                              "geometry_msgs/PointStamped",
                                              "geometry_msgs/PoseWithCovarianceStamped"};
  return types;
}

bool isDrawn(std::string_view type) {
  return std::find(drawnTypes().begin(), drawnTypes().end(), type) != drawnTypes().end();
}

Read<std::vector<Marker>> readDrawn(std::string_view type, const Field& msg, const std::string& name) {
  return readOne(type, msg, name).map([&](Marker marker) {
    marker.ns = name;
    marker.rgba = 0;  // the map's own colour
    const bool line = marker.kind == Marker::Kind::LineStrip || marker.kind == Marker::Kind::LineList;
    if (line) marker.scale_m.setZero();  // as thin as can be seen
    const bool seen = !marker.points.empty() || marker.kind == Marker::Kind::Sphere;
    if (!seen) marker.action = Marker::Action::Delete;
    return std::vector<Marker>{std::move(marker)};
  });
}

}  // namespace mapwright::robot::ros
