#include "align/local_fit.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "align/fit.h"

namespace mapwright::align {
using geometry::Pose2;

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
  double residual_m = distances[distances.size() / 2];
  // Walls along the way that they are off hide it: what the best local fit moves does not.
  if (const auto after = fittedAt(old_m))
    residual_m = std::max(residual_m, (after->apply(old_m) - move(old_m)).norm());
  return {double(within) / double(distances.size()), residual_m};
}

std::optional<Pose2> LocalFit::fittedAt(const Eigen::Vector2d& old_m) const {
  return fittedAround(parts_->sheets, parts_->old_walls, parts_->new_walls, parts_->transform, old_m);
}

}  // namespace mapwright::align
