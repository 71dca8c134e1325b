#include "align/fit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Dense>

namespace mapwright::align {
namespace {

using geometry::Pose2;

/// Chance alone gives walls this much agreement.
constexpr double kChance = 0.2;

struct Seen {
  std::size_t all = 0, seen = 0;
  double agreeing = 0;  // sum of 0..1
  double share() const { return seen == 0 ? 0 : agreeing / double(seen); }
  double seenShare() const { return all == 0 ? 0 : double(seen) / double(all); }
};

Seen seenIn(const Sheet& sheet, const std::vector<Eigen::Vector2d>& points, const Pose2& transform,
            double sigma_m) {
  Seen out;
  out.all = points.size();
  const Mover move(transform);
  for (const Eigen::Vector2d& p : points) {
    const auto distance = sheet.distanceAt(move(p));
    if (!distance) continue;
    ++out.seen;
    const double ratio = distance->metres / sigma_m;
    out.agreeing += std::exp(-0.5 * ratio * ratio);
  }
  return out;
}

}  // namespace

Points pointsFrom(std::vector<Eigen::Vector2d> of_old, std::vector<Eigen::Vector2d> of_new) {
  Points out{std::move(of_old), std::move(of_new)};
  for (const Eigen::Vector2d& wall : out.of_old) out.middle += wall;
  if (!out.of_old.empty()) out.middle /= double(out.of_old.size());
  for (const Eigen::Vector2d& wall : out.of_old)
    out.radius = std::max(out.radius, (wall - out.middle).norm());
  return out;
}

Points pointsOf(const Sheets& sheets, std::size_t most) {
  return pointsFrom(sheets.of_old.someWalls(most), sheets.of_new.someWalls(most));
}

Mover::Mover(const Pose2& pose)
    : turn_(Eigen::Rotation2Dd(pose.yaw_rad).toRotationMatrix()), by_(pose.x_m, pose.y_m) {}

double Quality::score() const { return agreement * std::sqrt(seen); }

Quality qualityOf(const Sheets& sheets, const Points& points, const Pose2& transform) {
  const double sigma = std::max({0.1, sheets.of_old.resolution(), sheets.of_new.resolution()});
  const Seen forward = seenIn(sheets.of_new, points.of_old, transform, sigma);
  const Seen backward = seenIn(sheets.of_old, points.of_new, transform.inverse(), sigma);
  const double both = std::sqrt(forward.share() * backward.share());
  return {std::max(0.0, (both - kChance) / (1 - kChance)),
          std::max(forward.seenShare(), backward.seenShare())};
}

Pose2 fitted(const Sheets& sheets, const Points& points, Pose2 pose,
             std::initializer_list<double> cutoffs_m) {
  for (const double cutoff : cutoffs_m) {
    for (int round = 0; round < 12; ++round) {
      const Eigen::Vector2d middle = pose.apply(points.middle);
      Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
      Eigen::Vector3d right = Eigen::Vector3d::Zero();
      double total = 0;
      const auto add = [&](const Sheet::Distance& distance, const Eigen::Vector2d& slope,
                           const Eigen::Vector2d& at, double sign) {
        const double ratio = distance.metres / cutoff;
        if (ratio >= 1) return;
        const double weight = (1 - ratio * ratio) * (1 - ratio * ratio);
        const Eigen::Vector2d arm = at - middle;
        const Eigen::Vector3d row(sign * slope.x(), sign * slope.y(),
                                  sign * (slope.y() * arm.x() - slope.x() * arm.y()) / points.radius);
        normal += weight * row * row.transpose();
        right -= weight * distance.metres * row;
        total += weight;
      };
      const Eigen::Matrix2d turn = Eigen::Rotation2Dd(pose.yaw_rad).toRotationMatrix();
      for (const Eigen::Vector2d& p : points.of_old) {
        const Eigen::Vector2d at = turn * p + Eigen::Vector2d(pose.x_m, pose.y_m);
        if (const auto distance = sheets.of_new.distanceAt(at)) add(*distance, distance->slope, at, 1);
      }
      const Pose2 back = pose.inverse();
      const Eigen::Matrix2d back_turn = turn.transpose();
      for (const Eigen::Vector2d& q : points.of_new) {
        const Eigen::Vector2d at = back_turn * q + Eigen::Vector2d(back.x_m, back.y_m);
        if (const auto distance = sheets.of_old.distanceAt(at)) add(*distance, turn * distance->slope, q, -1);
      }
      if (!(total > 3)) return pose;
      normal += 1e-4 * total * Eigen::Matrix3d::Identity();
      const Eigen::Vector3d step = normal.ldlt().solve(right);
      const double yaw = step.z() / points.radius;
      // Turned about the middle, then moved.
      const Eigen::Rotation2Dd by(yaw);
      const Eigen::Vector2d moved =
          by * (Eigen::Vector2d(pose.x_m, pose.y_m) - middle) + middle + Eigen::Vector2d(step.x(), step.y());
      pose = {moved.x(), moved.y(), geometry::normalizeAngle(pose.yaw_rad + yaw)};
      if (step.head<2>().norm() < 1e-4 && std::abs(step.z()) < 1e-4) break;
    }
  }
  return pose;
}

}  // namespace mapwright::align
