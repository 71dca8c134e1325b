#include "clouds/newest_clouds.h"

#include <algorithm>

#include "clouds/walk.h"

namespace mapwright::clouds {
namespace {

/// The assumed cell size if it cannot be detected: that of most maps.
constexpr double kUsualVoxelM = 0.05;

Covered coveredBy(const NewestClouds::Came& came) {
  const map::CloudRegion& region = *came.region;
  Covered covered;
  const Eigen::Vector3d half =
      region.radius_m > 0 ? Eigen::Vector3d::Constant(region.radius_m) : Eigen::Vector3d(region.size_m / 2);
  covered.box = {region.centre_m - half, region.centre_m + half};
  covered.centre_m = region.centre_m;
  covered.radius_m = region.radius_m;
  const Box points = came.tree->bounds();
  if (!points.empty()) {
    // Not in height: a floor that is slightly lower now is still the same floor.
    covered.box.min.head<2>() = covered.box.min.head<2>().cwiseMax(points.min.head<2>());
    covered.box.max.head<2>() = covered.box.max.head<2>().cwiseMin(points.max.head<2>());
  }
  return covered;
}

}  // namespace

std::uint64_t NewestClouds::oneOf(std::uint64_t points) {
  constexpr std::uint64_t kMostOfOne = kMostPoints / 2;
  return points <= kMostOfOne ? 1 : (points + kMostOfOne - 1) / kMostOfOne;
}

void NewestClouds::add(Came came) {
  const bool whole = !came.region;
  const std::optional<Covered> covered = whole ? std::nullopt : std::optional(coveredBy(came));
  std::erase_if(held_, [&](const Held& held) {
    if (held.came.kind != came.kind) return false;
    if (whole || held.came.region == came.region) return true;
    const Box bounds = held.came.tree->bounds();
    return bounds.empty() || coverage(*covered, bounds) == Visit::Whole;
  });
  held_.push_back({std::move(came), covered});
  std::uint64_t points = 0;
  for (const Held& held : held_) points += held.came.tree->size();
  while (held_.size() > 1 && (points > kMostPoints || held_.size() > kMostClouds)) {
    points -= held_.front().came.tree->size();
    held_.erase(held_.begin());
    ++forgotten_;
  }
}

void NewestClouds::clear() {
  held_.clear();
  forgotten_ = 0;
}

void NewestClouds::setVoxel(std::optional<double> metres) {
  voxel_m_ = metres && std::isfinite(*metres) && *metres > 0 ? metres : std::nullopt;
}

CloudSet NewestClouds::set() const {
  CloudSet set;
  const CloudTree* widest = nullptr;
  for (const Held& held : held_) {
    const CloudTree& tree = *held.came.tree;
    ShownCloud shown{held.came.tree, held.came.kind, 0, {}};
    for (const Held* newer = &held + 1; newer < held_.data() + held_.size(); ++newer) {
      // A cloud of the whole map is the oldest of its kind: it replaced all earlier ones.
      if (newer->came.kind == held.came.kind && newer->covered &&
          coverage(*newer->covered, tree.bounds()) != Visit::Skip) {
        shown.hidden.push_back(*newer->covered);
      }
    }
    if (held.came.kind == PointKind::Voxel) {
      shown.voxel_m = voxel_m_ ? *voxel_m_ : held.came.voxel_m > 0 ? held.came.voxel_m : kUsualVoxelM;
    }
    set.clouds.push_back(std::move(shown));
    const Box box = tree.bounds();
    if (box.empty()) continue;
    if (set.bounds.empty()) {
      set.bounds = box;
    } else {
      set.bounds = {set.bounds.min.cwiseMin(box.min), set.bounds.max.cwiseMax(box.max)};
    }
    if (tree.hasIntensity()) {
      const auto usual = tree.usualIntensity();
      set.usual_intensity = set.has_intensity ? std::array{std::min(usual[0], set.usual_intensity[0]),
                                                           std::max(usual[1], set.usual_intensity[1])}
                                              : usual;
    }
    set.has_intensity = set.has_intensity || tree.hasIntensity();
    set.has_rgb = set.has_rgb || tree.hasRgb();
    if (!widest || tree.size() > widest->size()) widest = &tree;
  }
  if (widest) set.spacing_m = widest->spacing();
  return set;
}

NewestClouds::Totals NewestClouds::totals() const {
  Totals totals;
  totals.clouds = held_.size();
  totals.forgotten = forgotten_;
  for (const Held& held : held_) {
    const CloudTree& tree = *held.came.tree;
    totals.came += held.came.points;
    totals.held += tree.size();
    totals.left_out += held.came.left_out;
    totals.thinned += held.came.points - std::min<std::uint64_t>(held.came.points, tree.size());
    totals.bytes += tree.bytes();
    totals.frames.insert(tree.frame());
    totals.without_z = totals.without_z || !tree.hasZ();
    if (held.came.kind == PointKind::Voxel) {
      totals.voxels = true;
      totals.voxel_m = held.came.voxel_m > 0 ? std::optional(held.came.voxel_m) : std::nullopt;
    }
  }
  return totals;
}

}  // namespace mapwright::clouds
