#include "simulator/lidar.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulator/noise.h"

namespace mapwright::simulator {
namespace {

using Eigen::Vector2d;

constexpr int kMostRays = 1440;
constexpr double kNoiseM = 0.012;
constexpr double kFirstHeightM = 0.04, kLayerM = 0.08;
constexpr int kLayers = 16;
constexpr double kTurn = 2 * std::numbers::pi;

/// Metres along the ray to the solid; infinity when it misses.
double hit(const Solid& solid, const Vector2d& start, const Vector2d& direction) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const Vector2d offset = solid.centre - start;
  if (solid.round) {
    const double along = offset.dot(direction);
    const double past = offset.squaredNorm() - along * along;
    const double radius = solid.half.x();
    if (along <= 0 || past > radius * radius) return kNever;
    return along - std::sqrt(radius * radius - past);
  }
  const double c = std::cos(solid.yaw_rad), s = std::sin(solid.yaw_rad);
  const double p[2] = {-(c * offset.x() + s * offset.y()), s * offset.x() - c * offset.y()};
  const double d[2] = {c * direction.x() + s * direction.y(), -s * direction.x() + c * direction.y()};
  double from = 0, to = kNever;
  for (int axis = 0; axis < 2; ++axis) {
    if (std::abs(d[axis]) < 1e-12) {
      if (std::abs(p[axis]) > solid.half[axis]) return kNever;
      continue;
    }
    const double a = (-solid.half[axis] - p[axis]) / d[axis], b = (solid.half[axis] - p[axis]) / d[axis];
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  return from <= to ? from : kNever;
}

/// The nearest solid on every ray; infinity where there is none.
std::vector<double> cast(const FloorPlan& plan, const geometry::Pose2& pose, int rays) {
  std::vector<double> ranges(static_cast<std::size_t>(rays), std::numeric_limits<double>::infinity());
  const Vector2d start(pose.x_m, pose.y_m), reach(kLidarRangeM, kLidarRangeM);
  const double step = kTurn / rays;
  for (const std::uint32_t index : plan.near(start - reach, start + reach)) {
    const Solid& solid = plan.solids()[index];
    const Vector2d offset = solid.centre - start;
    const double distance = offset.norm();
    // Only the rays within the solid's circle can meet it.
    const double half =
        distance <= solid.reach() ? std::numbers::pi : std::asin(solid.reach() / distance) + step;
    const double middle = std::atan2(offset.y(), offset.x()) - pose.yaw_rad;
    const int count = std::min(rays, static_cast<int>(std::ceil(2 * half / step)) + 1);
    const auto first = static_cast<long>(std::floor((middle - half) / step));
    for (int i = 0; i < count; ++i) {
      const auto ray = static_cast<std::size_t>(((first + i) % rays + rays) % rays);
      const double angle = pose.yaw_rad + step * static_cast<double>(ray);
      ranges[ray] = std::min(ranges[ray], hit(solid, start, {std::cos(angle), std::sin(angle)}));
    }
  }
  return ranges;
}

}  // namespace

std::vector<LidarPoint> scanFrom(const FloorPlan& plan, const geometry::Pose2& pose, int points,
                                 std::uint64_t seed) {
  std::vector<LidarPoint> found;
  if (points <= 0) return found;
  const int rays = std::clamp(points, 180, kMostRays);
  const std::vector<double> ranges = cast(plan, pose, rays);
  std::vector<std::size_t> hits;
  for (std::size_t ray = 0; ray < ranges.size(); ++ray) {
    if (ranges[ray] <= kLidarRangeM) hits.push_back(ray);
  }
  if (hits.empty()) return found;

  found.reserve(static_cast<std::size_t>(points));
  Dice dice(seed);
  for (std::size_t i = 0; found.size() < static_cast<std::size_t>(points); ++i) {
    const std::size_t ray = hits[i % hits.size()], layer = i / hits.size();
    const double angle = pose.yaw_rad + kTurn / rays * (static_cast<double>(ray) + dice.uniform(-0.4, 0.4));
    const double range = ranges[ray] + dice.uniform(-kNoiseM, kNoiseM);
    LidarPoint point;
    point.at_m = {pose.x_m + range * std::cos(angle), pose.y_m + range * std::sin(angle)};
    point.z_m = static_cast<float>(kFirstHeightM + kLayerM * static_cast<double>(layer % kLayers));
    point.intensity = static_cast<std::uint8_t>(40 + 200 * std::exp(-range / 8) * dice.uniform(0.6, 1));
    found.push_back(point);
  }
  return found;
}

std::vector<double> rangesFrom(const FloorPlan& plan, const geometry::Pose2& pose, int rays,
                               std::uint64_t seed) {
  std::vector<double> ranges = cast(plan, pose, rays);
  Dice dice(seed);
  for (double& range : ranges) {
    range = range <= kLidarRangeM ? range + dice.uniform(-kNoiseM, kNoiseM)
                                  : std::numeric_limits<double>::infinity();
  }
  return ranges;
}

}  // namespace mapwright::simulator
