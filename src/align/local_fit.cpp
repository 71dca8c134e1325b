#include "align/local_fit.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "align/fit.h"

namespace mapwright::align {
using geometry::Pose2;

namespace {

/// How far the walls around a point are from those of the other map, the nearest first.
std::vector<double> offAround(const WallIndex& walls, const Eigen::Vector2d& at, const Mover& move,
                              const Sheet& other) {
  std::vector<double> off;
  for (const Eigen::Vector2d& wall : walls.around(at, LocalFit::kReach_m)) {
    if (const auto distance = other.distanceAt(move(wall))) off.push_back(distance->metres);
  }
  std::sort(off.begin(), off.end());
  return off;
}

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
  const Mover move(parts_->transform), back(parts_->transform.inverse());
  const auto& [of_old, of_new] = parts_->sheets;
  const std::vector<double> old_off = offAround(parts_->old_walls, old_m, move, of_new);
  const std::vector<double> new_off = offAround(parts_->new_walls, move(old_m), back, of_old);
  Around out;
  if (!new_off.empty()) out.residual_m = new_off[new_off.size() / 2];
  if (old_off.empty()) return out;
  const auto within = std::upper_bound(old_off.begin(), old_off.end(), 0.10) - old_off.begin();
  out.within_10cm = double(within) / double(old_off.size());
  out.old_m = old_off[old_off.size() / 2];
  // Walls along the way that they are off hide it: what the best local fit moves does not.
  if (const auto after = fittedAt(old_m))
    out.old_m = std::max(*out.old_m, (after->apply(old_m) - move(old_m)).norm());
  out.residual_m = std::max(out.residual_m.value_or(0), *out.old_m);
  return out;
}

std::optional<Pose2> LocalFit::fittedAt(const Eigen::Vector2d& old_m) const {
  return fittedAround(parts_->sheets, parts_->old_walls, parts_->new_walls, parts_->transform, old_m);
}

}  // namespace mapwright::align
