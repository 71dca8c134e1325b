#include "align/fit.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
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

/// Those of `walls` that have the same side in sight on both maps.
std::vector<Eigen::Vector2d> seenAlike(const Sheet& from, const Sheet& to,
                                       const std::vector<Eigen::Vector2d>& walls, const Mover& move) {
  constexpr double kBefore_m = 0.2;
  const double before_m = std::max(kBefore_m, 2 * from.resolution());
  std::vector<Eigen::Vector2d> out;
  for (const Eigen::Vector2d& wall : walls) {
    int open = 0, in_both = 0;
    for (int side = 0; side < 8; ++side) {
      const double towards = side * std::numbers::pi / 4;
      const Eigen::Vector2d at = wall + before_m * Eigen::Vector2d(std::cos(towards), std::sin(towards));
      if (!from.freeAt(at)) continue;
      ++open;
      in_both += to.freeAt(move(at));
    }
    if (2 * in_both >= open) out.push_back(wall);
  }
  return out;
}

constexpr double kSquareSide_m = 2;
int squareAt(double metres) { return int(std::floor(std::clamp(metres, -1e9, 1e9) / kSquareSide_m)); }
std::int64_t squareKey(int x, int y) { return (std::int64_t(x) << 32) ^ std::int64_t(std::uint32_t(y)); }

/// The normal equations of one step of the fit; the turn is counted in metres at points.radius.
struct Equations {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double total = 0;
};

Equations equationsAt(const Sheets& sheets, const Points& points, const Pose2& pose, double cutoff_m) {
  Equations out;
  const Eigen::Vector2d middle = pose.apply(points.middle);
  const auto add = [&](const Sheet::Distance& distance, const Eigen::Vector2d& slope,
                       const Eigen::Vector2d& at, double sign) {
    const double ratio = distance.metres / cutoff_m;
    if (ratio >= 1) return;
    const double weight = (1 - ratio * ratio) * (1 - ratio * ratio);
    const Eigen::Vector2d arm = at - middle;
    const Eigen::Vector3d row(sign * slope.x(), sign * slope.y(),
                              sign * (slope.y() * arm.x() - slope.x() * arm.y()) / points.radius);
    out.normal += weight * row * row.transpose();
    out.right -= weight * distance.metres * row;
    out.total += weight;
  };
  const Mover move(pose), move_back(pose.inverse());
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(pose.yaw_rad).toRotationMatrix();
  for (const Eigen::Vector2d& p : points.of_old) {
    const Eigen::Vector2d at = move(p);
    if (const auto distance = sheets.of_new.distanceAt(at)) add(*distance, distance->slope, at, 1);
  }
  for (const Eigen::Vector2d& q : points.of_new) {
    if (const auto distance = sheets.of_old.distanceAt(move_back(q)))
      add(*distance, turn * distance->slope, q, -1);
  }
  return out;
}

}  // namespace

WallIndex::WallIndex(const std::vector<Eigen::Vector2d>& walls) {
  for (const Eigen::Vector2d& wall : walls)
    squares_[squareKey(squareAt(wall.x()), squareAt(wall.y()))].push_back(wall);
}

std::vector<Eigen::Vector2d> WallIndex::around(const Eigen::Vector2d& at, double reach_m) const {
  std::vector<Eigen::Vector2d> found;
  for (int x = squareAt(at.x() - reach_m); x <= squareAt(at.x() + reach_m); ++x) {
    for (int y = squareAt(at.y() - reach_m); y <= squareAt(at.y() + reach_m); ++y) {
      const auto square = squares_.find(squareKey(x, y));
      if (square == squares_.end()) continue;
      std::copy_if(square->second.begin(), square->second.end(), std::back_inserter(found),
                   [&](const Eigen::Vector2d& wall) { return (wall - at).norm() <= reach_m; });
    }
  }
  return found;
}

std::optional<Pose2> fittedAround(const Sheets& sheets, const WallIndex& old_walls,
                                  const WallIndex& new_walls, const Pose2& transform,
                                  const Eigen::Vector2d& old_m) {
  constexpr double kMost_m = 0.5, kMost_rad = 0.09;
  const Eigen::Vector2d at = transform.apply(old_m);
  const Points points = pointsFrom(old_walls.around(old_m, kAround_m), new_walls.around(at, kAround_m));
  const Pose2 after = fitted(sheets, points, transform, {0.6, 0.3});
  if ((after.apply(old_m) - at).norm() > kMost_m ||
      std::abs(geometry::normalizeAngle(after.yaw_rad - transform.yaw_rad)) > kMost_rad)
    return std::nullopt;
  if (qualityOf(sheets, points, after).agreement <= qualityOf(sheets, points, transform).agreement)
    return std::nullopt;
  return after;
}

Motion weakestMotion(const Sheets& sheets, const Points& points, const Pose2& pose) {
  constexpr double kStep_m = 0.1;
  double square = 0;
  for (const Eigen::Vector2d& point : points.of_old) square += (point - points.middle).squaredNorm();
  const double usual_m =
      std::max(1.0, std::sqrt(square / double(std::max<std::size_t>(points.of_old.size(), 1))));
  const auto motionOf = [&](const Eigen::Vector3d& step) {
    return Motion{step.head<2>(), step.z() / usual_m};
  };
  const auto scoreAt = [&](const Eigen::Vector3d& step) {
    return qualityOf(sheets, points, movedBy(pose, points, motionOf(step), kStep_m)).score();
  };
  // How the score bends around the pose: the slopes of distances vanish where the walls fit.
  Eigen::Matrix3d bend;
  const double here = scoreAt(Eigen::Vector3d::Zero());
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d a = Eigen::Vector3d::Unit(i);
    bend(i, i) = scoreAt(a) + scoreAt(-a) - 2 * here;
    for (int j = 0; j < i; ++j) {
      const Eigen::Vector3d b = Eigen::Vector3d::Unit(j);
      bend(i, j) = bend(j, i) = (scoreAt(a + b) + scoreAt(-a - b) - scoreAt(a - b) - scoreAt(b - a)) / 4;
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(bend);
  return motionOf(solver.eigenvectors().col(2));  // of the largest eigenvalue: all are negative at a peak
}

Pose2 movedBy(const Pose2& pose, const Points& points, const Motion& motion, double times) {
  const Eigen::Vector2d middle = pose.apply(points.middle);
  const Eigen::Rotation2Dd turn(motion.turn_rad * times);
  const Eigen::Vector2d moved =
      turn * (Eigen::Vector2d(pose.x_m, pose.y_m) - middle) + middle + times * motion.by_m;
  return {moved.x(), moved.y(), geometry::normalizeAngle(pose.yaw_rad + motion.turn_rad * times)};
}

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

Points facedAlike(const Sheets& sheets, const std::vector<Eigen::Vector2d>& of_old,
                  const std::vector<Eigen::Vector2d>& of_new, const Pose2& pose) {
  return pointsFrom(seenAlike(sheets.of_old, sheets.of_new, of_old, Mover(pose)),
                    seenAlike(sheets.of_new, sheets.of_old, of_new, Mover(pose.inverse())));
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
      Equations equations = equationsAt(sheets, points, pose, cutoff);
      if (!(equations.total > 3)) return pose;
      equations.normal += 1e-4 * equations.total * Eigen::Matrix3d::Identity();
      const Eigen::Vector3d step = equations.normal.ldlt().solve(equations.right);
      pose = movedBy(pose, points, {{step.x(), step.y()}, step.z() / points.radius}, 1);
      if (step.head<2>().norm() < 1e-4 && std::abs(step.z()) < 1e-4) break;
    }
  }
  return pose;
}

}  // namespace mapwright::align
