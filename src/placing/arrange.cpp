#include "placing/arrange.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "geometry/pose.h"

namespace mapwright::placing {
namespace {

constexpr double kRounding = 1e-9;  // of a spacing: rounding errors
constexpr std::size_t kLongestNumber = 9;
constexpr double kOnePlaceM = 1e-6;  // closer ones lie in one place

std::pair<double, double> rangeOf(const std::vector<Spot>& spots, int axis) {
  const auto [least, most] = std::minmax_element(
      spots.begin(), spots.end(),
      [axis](const Spot& a, const Spot& b) { return a.position_m[axis] < b.position_m[axis]; });
  return {least->position_m[axis], most->position_m[axis]};
}

}  // namespace

Eigen::Vector2d middleOf(const std::vector<Spot>& spots) {
  Eigen::Vector2d sum(0, 0);
  for (const Spot& spot : spots) sum += spot.position_m;
  return spots.empty() ? sum : sum / double(spots.size());
}

std::vector<Spot> turned(std::vector<Spot> spots, const Eigen::Vector2d& pivot_m, double by_rad) {
  const Eigen::Rotation2Dd turn(by_rad);
  for (Spot& spot : spots) {
    spot.position_m = pivot_m + turn * (spot.position_m - pivot_m);
    if (spot.yaw_rad) spot.yaw_rad = geometry::normalizeAngle(*spot.yaw_rad + by_rad);
  }
  return spots;
}

std::vector<Spot> mirrored(std::vector<Spot> spots, const Eigen::Vector2d& through_m, double along_rad) {
  const Eigen::Rotation2Dd there(along_rad), back(-along_rad);
  for (Spot& spot : spots) {
    const Eigen::Vector2d of_line = back * (spot.position_m - through_m);
    spot.position_m = through_m + there * Eigen::Vector2d(of_line.x(), -of_line.y());
    if (spot.yaw_rad) spot.yaw_rad = geometry::normalizeAngle(2 * along_rad - *spot.yaw_rad);
  }
  return spots;
}

std::vector<Spot> alongLine(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m, double spacing_m) {
  const Eigen::Vector2d line = to_m - from_m;
  const double length = line.norm();
  if (!(length > 0) || !(spacing_m > 0) || !std::isfinite(length)) return {};
  const double steps = std::floor(length / spacing_m + kRounding);
  if (steps + 1 > double(kMostAlongLine)) return {};
  const double yaw = std::atan2(line.y(), line.x());
  std::vector<Spot> spots;
  spots.reserve(std::size_t(steps) + 1);
  for (int i = 0; i <= int(steps); ++i)
    spots.push_back({from_m + line * (i * spacing_m / length), std::optional(yaw)});
  return spots;
}

std::vector<Spot> aligned(std::vector<Spot> spots, Axis axis) {
  if (spots.empty()) return spots;
  const int at = axis == Axis::X ? 0 : 1;
  const auto [least, most] = rangeOf(spots, at);
  for (Spot& spot : spots) spot.position_m[at] = (least + most) / 2;
  return spots;
}

std::vector<Spot> distributed(std::vector<Spot> spots, Axis axis) {
  if (spots.size() < 3) return spots;
  const int at = axis == Axis::X ? 0 : 1;
  std::vector<std::size_t> order(spots.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return spots[a].position_m[at] < spots[b].position_m[at];
  });
  const auto [least, most] = rangeOf(spots, at);
  for (std::size_t i = 0; i < order.size(); ++i)
    spots[order[i]].position_m[at] = least + (most - least) * double(i) / double(order.size() - 1);
  return spots;
}

std::vector<Spot> headingOn(std::vector<Spot> spots, LastHeads last) {
  const std::size_t count = spots.size();
  std::optional<Eigen::Vector2d> next;  // the nearest one after it that lies elsewhere
  const auto isElsewhere = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return (a - b).norm() > kOnePlaceM;
  };
  const auto headTo = [](Spot& spot, const Eigen::Vector2d& there) {
    const Eigen::Vector2d towards = there - spot.position_m;
    spot.yaw_rad = std::atan2(towards.y(), towards.x());
  };
  std::size_t ahead = count;  // from here on all lie where the last one does
  for (std::size_t i = count; i-- > 0;) {
    if (i + 1 < count && isElsewhere(spots[i].position_m, spots[i + 1].position_m))
      next = spots[i + 1].position_m;
    if (!next) {
      ahead = i;
      continue;
    }
    headTo(spots[i], *next);
  }
  if (ahead == 0 || ahead >= count) return spots;  // one place, or none
  for (std::size_t i = ahead; i < count; ++i) {
    const Eigen::Vector2d& first = spots.front().position_m;
    if (last == LastHeads::OnAsBefore || !isElsewhere(first, spots[i].position_m)) {
      spots[i].yaw_rad = spots[ahead - 1].yaw_rad;
    } else {
      headTo(spots[i], first);
    }
  }
  return spots;
}

std::vector<std::size_t> orderOf(const std::vector<Spot>& spots, Order order) {
  std::vector<std::size_t> indices(spots.size());
  std::iota(indices.begin(), indices.end(), 0);
  if (order == Order::AsGiven || spots.empty()) return indices;
  Eigen::Vector2d along = order == Order::Y ? Eigen::Vector2d::UnitY() : Eigen::Vector2d::UnitX();
  if (order == Order::AlongLine) {
    const Eigen::Vector2d middle = middleOf(spots);
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (const Spot& spot : spots)
      spread += (spot.position_m - middle) * (spot.position_m - middle).transpose();
    along = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvectors().col(1);
    const bool is_vertical = std::abs(along.x()) < kRounding;
    if (is_vertical ? along.y() < 0 : along.x() < 0) along = -along;
  }
  std::stable_sort(indices.begin(), indices.end(), [&](std::size_t a, std::size_t b) {
    return spots[a].position_m.dot(along) < spots[b].position_m.dot(along);
  });
  return indices;
}

Eigen::Vector2d centreOf(const std::vector<Spot>& spots) {
  if (spots.empty()) return {0, 0};
  const auto [left, right] = rangeOf(spots, 0);
  const auto [bottom, top] = rangeOf(spots, 1);
  return {(left + right) / 2, (bottom + top) / 2};
}

std::string nextName(const std::string& name, std::set<std::string>& taken) {
  std::size_t digits = name.size();
  while (digits > 0 && name.size() - digits < kLongestNumber && name[digits - 1] >= '0' &&
         name[digits - 1] <= '9')
    --digits;
  const bool numbered = digits < name.size() && digits > 0 && name[digits - 1] == ' ';
  const std::string stem = numbered ? name.substr(0, digits) : name + " ";
  std::int64_t number = numbered ? std::stoll(name.substr(digits)) : 1;
  std::string next;
  do {
    next = stem + std::to_string(++number);
  } while (!taken.insert(next).second);
  return next;
}

}  // namespace mapwright::placing
