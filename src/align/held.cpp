#include "align/held.h"

#include <array>
#include <cmath>
#include <vector>

namespace mapwright::align {
namespace {

using geometry::Pose2;

constexpr double kNear_m = 0.25;     // walls farther apart are not the same
constexpr std::size_t kFewest = 40;  // cells of walls of both maps

bool enough(const Points& points) { return points.of_old.size() + points.of_new.size() >= kFewest; }

constexpr int kParts = 8;
/// Squares of a part lie all over the map.
int partAt(const Eigen::Vector2d& at_m) {
  constexpr double kSide_m = 3.0;
  const int x = int(std::floor(at_m.x() / kSide_m)), y = int(std::floor(at_m.y() / kSide_m));
  return ((3 * x + 5 * y) % kParts + kParts) % kParts;
}

Points without(int part, const Points& points, const Pose2& pose) {
  std::vector<Eigen::Vector2d> of_old, of_new;
  const Mover move(pose);
  for (const Eigen::Vector2d& wall : points.of_old) {
    if (partAt(move(wall)) != part) of_old.push_back(wall);
  }
  for (const Eigen::Vector2d& wall : points.of_new) {
    if (partAt(wall) != part) of_new.push_back(wall);
  }
  return pointsFrom(std::move(of_old), std::move(of_new));
}

}  // namespace

Pose2 sharpened(const Sheets& sheets, const Points& points, const Pose2& pose) {
  const Points alike = facedAlike(sheets, points.of_old, points.of_new, pose);
  return enough(alike) ? fitted(sheets, alike, pose, {kNear_m}) : pose;
}

bool heldByWalls(const Sheets& sheets, const Points& points, const Pose2& pose) {
  constexpr double kMost_m = 0.05, kMost_rad = geometry::radiansFromDegrees(0.3), kSigmas = 2.5;
  const Points alike = facedAlike(sheets, points.of_old, points.of_new, pose);
  if (!enough(alike)) return false;
  // The jackknife: how much the place moves when each part is left out.
  std::array<Eigen::Vector3d, kParts> moved;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (int part = 0; part < kParts; ++part) {
    const Pose2 left = fitted(sheets, without(part, alike, pose), pose, {kNear_m});
    const Eigen::Vector2d by = left.apply(alike.middle) - pose.apply(alike.middle);
    moved[std::size_t(part)] = {by.x(), by.y(), geometry::normalizeAngle(left.yaw_rad - pose.yaw_rad)};
    mean += moved[std::size_t(part)] / kParts;
  }
  Eigen::Vector3d variance = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& one : moved)
    variance += (one - mean).cwiseAbs2() * (kParts - 1) / double(kParts);
  return kSigmas * std::sqrt(variance.x() + variance.y()) <= kMost_m &&
         kSigmas * std::sqrt(variance.z()) <= kMost_rad;
}

}  // namespace mapwright::align
