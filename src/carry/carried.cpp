#include "carry/carried.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "align/local_fit.h"
#include "align/plan_of.h"
#include "carry/areas.h"

namespace mapwright::carry {
namespace {

using geometry::Pose2;

/// If fewer of the walls around it agree, they do not support its place.
constexpr double kAgrees = 0.2;
/// Walls of the old map that are farther off do not, either. New ones may just have been put there.
constexpr double kFarOff_m = 0.3;

double wallDistance(placing::Ground& ground, const Eigen::Vector2d& at, double reach_m) {
  const auto wall = ground.nearestWall(at, reach_m);
  return wall ? wall->distance_m : reach_m;
}

}  // namespace

placing::Ground groundOf(const render::PlacedGrid& map) {
  return {placing::PlacedMap{map.cells, map.reference, false}, placing::Ground::Access::Wait};
}

const char* nameOf(Verdict verdict) {
  constexpr std::array<const char*, kVerdicts> names{"kept",    "adjusted",    "in_obstacle",
                                                     "outside", "unreachable", "not_supported"};
  return names[std::size_t(verdict)];
}

struct Site::Parts {
  render::PlacedGrid old_map, new_map;
  Pose2 transform;
  align::Plan new_plan;
  align::LocalFit fit;
};

Site::Site(const render::PlacedGrid& old_map, const render::PlacedGrid& new_map, const Pose2& transform) {
  const double cell_m = align::cellsFor(old_map, new_map);
  const align::Plan old_plan = *align::planOf(old_map, cell_m);
  align::Plan new_plan = *align::planOf(new_map, cell_m);
  align::LocalFit fit(old_plan, new_plan, transform);
  parts_ =
      std::make_unique<const Parts>(Parts{old_map, new_map, transform, std::move(new_plan), std::move(fit)});
}
Site::~Site() = default;

Carried Site::carriedShape(const std::vector<Eigen::Vector2d>& old_points, bool adjust) const {
  Eigen::Vector2d middle(0, 0);
  for (const Eigen::Vector2d& point : old_points) middle += point / double(old_points.size());
  Carried out;
  out.transform = parts_->transform;
  const align::LocalFit::Around around = parts_->fit.around(middle);
  out.local_residual_m = around.residual_m;
  if (adjust) {
    if (const auto fitted = parts_->fit.fittedAt(middle))
      out.transform = *fitted, out.verdict = Verdict::Adjusted;
  }
  out.spot.position_m = out.transform.apply(middle);
  placing::Ground ground = groundOf(parts_->new_map);
  const bool seen = std::any_of(old_points.begin(), old_points.end(), [&](const Eigen::Vector2d& point) {
    const placing::Cell cell = ground.at(out.transform.apply(point));
    return cell == placing::Cell::Free || cell == placing::Cell::Occupied;
  });
  if (!seen) {
    out.verdict = Verdict::Outside;
  } else if (out.verdict == Verdict::Kept &&
             (around.within_10cm < kAgrees || around.old_m.value_or(0) > kFarOff_m)) {
    out.verdict = Verdict::NotSupported;
  }
  return out;
}

Carried Site::carriedStop(const Spot& old_spot, const CarryOptions& options) const {
  Carried out = carriedShape({old_spot.position_m}, options.adjust);
  if (old_spot.yaw_rad)
    out.spot.yaw_rad = geometry::normalizeAngle(*old_spot.yaw_rad + out.transform.yaw_rad);
  placing::Ground old_ground = groundOf(parts_->old_map), new_ground = groundOf(parts_->new_map);
  const double radius = std::max(options.radius_m, 0.0);
  const double now = wallDistance(new_ground, out.spot.position_m, radius + kCloser_m);
  const double before = wallDistance(old_ground, old_spot.position_m, radius + kCloser_m);
  const bool in_wall = new_ground.at(out.spot.position_m) == placing::Cell::Occupied;
  const bool too_close = out.verdict != Verdict::Outside && now < radius && now < before - kCloser_m;
  if (in_wall || too_close) out.verdict = Verdict::InObstacle;
  return out;
}

std::vector<Carried> Site::carried(const std::vector<Spot>& old_spots, const CarryOptions& options) const {
  std::vector<Carried> all;
  for (const Spot& spot : old_spots) all.push_back(carriedStop(spot, options));
  const Areas areas(parts_->new_plan, options.radius_m);
  std::map<int, int> spots_in;
  std::vector<int> area_of;
  for (const Carried& one : all) {
    area_of.push_back(areas.at(one.spot.position_m));
    if (sound(one.verdict)) ++spots_in[area_of.back()];
  }
  spots_in.erase(0);
  const auto most = std::max_element(spots_in.begin(), spots_in.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  for (std::size_t i = 0; i < all.size() && most != spots_in.end(); ++i) {
    if (sound(all[i].verdict) && area_of[i] != most->first) all[i].verdict = Verdict::Unreachable;
  }
  return all;
}

}  // namespace mapwright::carry
