#include "clouds/crop.h"

#include <cmath>

namespace mapwright::clouds {
namespace {

constexpr double kRimM = 1e-3;  // numbers of 32 bits, far from 0

bool liesIn(const map::CloudRegion& region, const Eigen::Vector3d& at_m) {
  const Eigen::Vector3d off = at_m - region.centre_m;
  const double rim = kRimM + at_m.cwiseAbs().maxCoeff() * 1e-7;
  if (region.radius_m > 0) return off.norm() <= region.radius_m + rim;
  return (off.array().abs() <= region.size_m.array() / 2 + rim).all();
}

}  // namespace

CroppedCloud cropped(std::shared_ptr<const map::SpatialCloud> cloud, const map::CloudRegion& region) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < cloud->points.size(); ++i) {
    if (liesIn(region, cloud->origin_m + cloud->points[i].cast<double>())) kept.push_back(i);
  }
  const std::uint64_t beyond = cloud->points.size() - kept.size();
  if (beyond == 0) return {std::move(cloud), 0};
  auto part = std::make_shared<map::SpatialCloud>();
  part->frame = cloud->frame;
  part->origin_m = cloud->origin_m;
  part->has_z = cloud->has_z;
  part->left_out = cloud->left_out;
  part->missing = cloud->missing;
  part->notes = cloud->notes;
  const auto copyKept = [&kept](const auto& from, auto& into) {
    if (from.empty()) return;
    into.reserve(kept.size());
    for (const std::size_t i : kept) into.push_back(from[i]);
  };
  copyKept(cloud->points, part->points);
  copyKept(cloud->intensity, part->intensity);
  copyKept(cloud->rgb, part->rgb);
  return {std::move(part), beyond};
}

}  // namespace mapwright::clouds
