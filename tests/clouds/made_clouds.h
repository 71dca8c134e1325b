// Clouds made for tests, and what a cloud comes to when every point is looked at.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <random>

#include "clouds/cloud_tree.h"
#include "clouds/draw_cloud.h"
#include "clouds/newest_clouds.h"

namespace mapwright::test {

/// Scattered over a room of that size, with intensities and colours.
inline map::SpatialCloud scattered(std::size_t points, double width_m, double height_m, unsigned seed,
                                   const Eigen::Vector3d& origin = {0, 0, 0}) {
  std::mt19937 random(seed);
  // Not std::uniform_real_distribution, which differs between libraries.
  const auto within = [&random](double width) { return float(double(random()) / 4294967296.0 * width); };
  map::SpatialCloud cloud;
  cloud.frame = "map";
  cloud.origin_m = origin;
  for (std::size_t i = 0; i < points; ++i) {
    cloud.points.emplace_back(within(width_m), within(width_m), within(height_m));
    cloud.intensity.push_back(within(255));
    cloud.rgb.push_back(random() & 0xffffff);
  }
  return cloud;
}

inline std::shared_ptr<const clouds::CloudTree> treeOf(const map::SpatialCloud& cloud) {
  return clouds::CloudTree::make(cloud);
}

inline clouds::NewestClouds::Came came(const map::SpatialCloud& cloud,
                                       std::optional<map::CloudRegion> region = {},
                                       clouds::PointKind kind = clouds::PointKind::Point) {
  clouds::NewestClouds::Came made;
  made.kind = kind;
  made.region = region;
  made.tree = treeOf(cloud);
  made.points = cloud.points.size();
  made.left_out = cloud.left_out;
  return made;
}

inline clouds::CloudSet setOf(const map::SpatialCloud& cloud,
                              clouds::PointKind kind = clouds::PointKind::Point) {
  clouds::NewestClouds newest;
  newest.add(came(cloud, {}, kind));
  return newest.set();
}

inline map::CloudRegion box(const Eigen::Vector3d& centre, const Eigen::Vector3d& size) {
  map::CloudRegion region;
  region.centre_m = centre;
  region.size_m = size;
  return region;
}

}  // namespace mapwright::test
