#include "clouds/section.h"

#include <algorithm>
#include <cmath>

#include "clouds/walk.h"

namespace mapwright::clouds {
namespace {

/// The position of points in a strip: along the line and beside it.
class Strip {
 public:
  explicit Strip(const Cut& cut)
      : from_(cut.from_m),
        along_((cut.to_m - cut.from_m).normalized()),
        length_(cut.length()),
        half_(cut.width_m / 2) {}

  double along(const Eigen::Vector2d& at) const { return (at - from_).dot(along_); }
  double beside(const Eigen::Vector2d& at) const {
    return (at.x() - from_.x()) * -along_.y() + (at.y() - from_.y()) * along_.x();
  }
  bool has(const Eigen::Vector2d& at) const {
    const double l = along(at);
    return l >= 0 && l <= length_ && std::abs(beside(at)) <= half_;
  }
  Visit of(const Box& box) const {
    const Eigen::Vector2d centre = (box.min.head<2>() + box.max.head<2>()) / 2;
    const Eigen::Vector2d half = (box.max.head<2>() - box.min.head<2>()) / 2;
    const double reach_along = std::abs(along_.x()) * half.x() + std::abs(along_.y()) * half.y();
    const double reach_beside = std::abs(along_.y()) * half.x() + std::abs(along_.x()) * half.y();
    const double l = along(centre), b = std::abs(beside(centre));
    // Slightly more, for rounding at the edges.
    const double slack = 1e-9 * (1 + std::abs(l) + b);
    if (l + reach_along < -slack || l - reach_along > length_ + slack || b - reach_beside > half_ + slack) {
      return Visit::Skip;
    }
    return Visit::Into;
  }

 private:
  Eigen::Vector2d from_, along_;
  double length_, half_;
};

template <class One>
void eachInStrip(const ShownCloud& cloud, const Strip& strip, const HeightRange& heights,
                 const std::atomic<bool>* cancelled, One one) {
  const CloudTree& tree = *cloud.tree;
  const Meant meant(tree, cloud.hidden, heights);
  walk(
      tree,
      [&](const CloudNode& node) {
        if ((cancelled && *cancelled) || meant.of(node) == Visit::Skip) return Visit::Skip;
        return strip.of(tree.boundsOf(node));
      },
      [](const CloudNode&) {},
      [&](std::uint32_t i) {
        if (strip.has(tree.world(i).head<2>()) && meant.has(tree.points()[i])) one(i);
      });
}

}  // namespace

Section cutThrough(const CloudSet& set, const Cut& cut, const HeightRange& heights,
                   const std::atomic<bool>* cancelled) {
  Section section;
  section.cut = cut;
  section.low_m = 0;
  section.high_m = -1;
  const double length = cut.length();
  if (!(std::isfinite(length) && length > 0 && std::isfinite(cut.width_m) && cut.width_m > 0 &&
        cut.from_m.allFinite())) {
    return section;
  }
  const Strip strip(cut);
  for (const ShownCloud& cloud : set.clouds) {
    eachInStrip(cloud, strip, heights, cancelled, [&](std::uint32_t) { ++section.points; });
  }
  section.one_of = std::max<std::uint64_t>(1, (section.points + kMostSectionPoints - 1) / kMostSectionPoints);
  section.set.usual_intensity = set.usual_intensity;
  section.set.has_intensity = set.has_intensity;
  section.set.has_rgb = set.has_rgb;
  std::uint64_t passed = 0;
  for (const PointKind kind : {PointKind::Voxel, PointKind::Point}) {
    map::SpatialCloud side;
    double voxel_m = 0;
    bool first = true;
    for (const ShownCloud& cloud : set.clouds) {
      if (cloud.kind != kind) continue;
      const CloudTree& tree = *cloud.tree;
      eachInStrip(cloud, strip, heights, cancelled, [&](std::uint32_t i) {
        if (passed++ % section.one_of != 0) return;
        const Eigen::Vector3d at = tree.world(i);
        if (first) {
          side.frame = tree.frame();
          // Heights become y, relative to an origin, so that millimetres survive at large heights.
          side.origin_m = {0, std::round(at.z()), std::round(at.z())};
          first = false;
        }
        const auto z = float(at.z() - side.origin_m.z());
        side.points.emplace_back(float(strip.along(at.head<2>())), z, z);
        // Points without a value among others that have one are dark, or of no intensity.
        if (set.has_intensity)
          side.intensity.push_back(tree.hasIntensity() ? tree.intensity()[i] : set.usual_intensity[0]);
        if (set.has_rgb) side.rgb.push_back(tree.hasRgb() ? tree.rgb()[i] : 0x808080);
        if (section.low_m > section.high_m) section.low_m = section.high_m = at.z();
        section.low_m = std::min(section.low_m, at.z());
        section.high_m = std::max(section.high_m, at.z());
        voxel_m = cloud.voxel_m;
      });
    }
    if (side.points.empty()) continue;
    auto tree = CloudTree::make(side, 1, cancelled);
    if (!tree) return {};
    if (kind == PointKind::Point || section.set.spacing_m <= 0) section.set.spacing_m = tree->spacing();
    section.set.clouds.push_back({std::move(tree), kind, voxel_m, {}});
  }
  return section;
}

std::optional<Eigen::Vector2d> nearestIn(const Section& section, const Eigen::Vector2d& at, double reach_m) {
  std::optional<Eigen::Vector2d> nearest;
  double best = reach_m * reach_m;
  for (const ShownCloud& cloud : section.set.clouds) {
    const CloudTree& tree = *cloud.tree;
    walk(
        tree,
        [&](const CloudNode& node) {
          const Box box = tree.boundsOf(node);
          const Eigen::Vector2d inside = at.cwiseMax(box.min.head<2>()).cwiseMin(box.max.head<2>());
          return (inside - at).squaredNorm() > best ? Visit::Skip : Visit::Into;
        },
        [](const CloudNode&) {},
        [&](std::uint32_t i) {
          const Eigen::Vector2d point = tree.world(i).head<2>();
          const double distance = (point - at).squaredNorm();
          if (distance > best || (nearest && distance == best)) return;
          best = distance;
          nearest = point;
        });
  }
  return nearest;
}

}  // namespace mapwright::clouds
