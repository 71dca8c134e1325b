#include "align/local_fit.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <vector>

#include "align/fit.h"

namespace mapwright::align {
namespace {

using geometry::Pose2;

/// Walls by squares, so that those around a point are found without looking at all.
class WallIndex {
 public:
  explicit WallIndex(const std::vector<Eigen::Vector2d>& walls) {
    for (const Eigen::Vector2d& wall : walls)
      squares_[keyOf(square(wall.x()), square(wall.y()))].push_back(wall);
  }
  std::vector<Eigen::Vector2d> around(const Eigen::Vector2d& at, double reach_m) const {
    std::vector<Eigen::Vector2d> found;
    for (int x = square(at.x() - reach_m); x <= square(at.x() + reach_m); ++x) {
      for (int y = square(at.y() - reach_m); y <= square(at.y() + reach_m); ++y) {
        const auto square = squares_.find(keyOf(x, y));
        if (square == squares_.end()) continue;
        std::copy_if(square->second.begin(), square->second.end(), std::back_inserter(found),
                     [&](const Eigen::Vector2d& wall) { return (wall - at).norm() <= reach_m; });
      }
    }
    return found;
  }

 private:
  static constexpr double kSquare_m = 2;
  static int square(double metres) { return int(std::floor(std::clamp(metres, -1e9, 1e9) / kSquare_m)); }
  static std::int64_t keyOf(int x, int y) { return (std::int64_t(x) << 32) ^ std::int64_t(std::uint32_t(y)); }
  std::unordered_map<std::int64_t, std::vector<Eigen::Vector2d>> squares_;
};

}  // namespace

struct LocalFit::Parts {
  Sheets sheets;
  WallIndex old_walls, new_walls;
  Pose2 transform;
};

LocalFit::LocalFit(const Plan& old_map, const Plan& new_map, const Pose2& transform) {
  Sheets sheets{Sheet(seenOnly(old_map, Sheet::kReach_m)), Sheet(seenOnly(new_map, Sheet::kReach_m))};
  WallIndex of_old(sheets.of_old.walls()), of_new(sheets.of_new.walls());
  parts_ = std::make_unique<const Parts>(
      Parts{std::move(sheets), std::move(of_old), std::move(of_new), transform});
}
LocalFit::~LocalFit() = default;
LocalFit::LocalFit(LocalFit&&) noexcept = default;

LocalFit::Around LocalFit::around(const Eigen::Vector2d& old_m) const {
  const Mover move(parts_->transform);
  std::vector<double> distances;
  for (const Eigen::Vector2d& wall : parts_->old_walls.around(old_m, kReach_m)) {
    if (const auto distance = parts_->sheets.of_new.distanceAt(move(wall)))
      distances.push_back(distance->metres);
  }
  if (distances.empty()) return {};
  std::sort(distances.begin(), distances.end());
  const auto within = std::upper_bound(distances.begin(), distances.end(), 0.10) - distances.begin();
  return {double(within) / double(distances.size()), distances[distances.size() / 2]};
}

std::optional<Pose2> LocalFit::fittedAt(const Eigen::Vector2d& old_m) const {
  constexpr double kMost_m = 0.5, kMost_rad = 0.09;
  const Pose2& before = parts_->transform;
  const Eigen::Vector2d at = before.apply(old_m);
  const Points points =
      pointsFrom(parts_->old_walls.around(old_m, kReach_m), parts_->new_walls.around(at, kReach_m));
  const Pose2 after = fitted(parts_->sheets, points, before, {0.6, 0.3});
  if ((after.apply(old_m) - at).norm() > kMost_m ||
      std::abs(geometry::normalizeAngle(after.yaw_rad - before.yaw_rad)) > kMost_rad)
    return std::nullopt;
  if (qualityOf(parts_->sheets, points, after).agreement <=
      qualityOf(parts_->sheets, points, before).agreement)
    return std::nullopt;
  return after;
}

}  // namespace mapwright::align
