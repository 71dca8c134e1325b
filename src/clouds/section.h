// A cross-section of a cloud: the points of a strip, seen from the side. Pure.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

#include <Eigen/Core>

#include "clouds/newest_clouds.h"

namespace mapwright::clouds {

/// Metres, in the map's frame. Contains everything within half the width on either side of the line between
/// start and end.
struct Cut {
  Eigen::Vector2d from_m{0, 0}, to_m{1, 0};
  double width_m = 0.5;
  double length() const { return (to_m - from_m).norm(); }
  bool operator==(const Cut&) const = default;
};

/// As points of a plane: x is the distance along the line, y and z are the height. In the order of the set.
struct Section {
  Cut cut;
  CloudSet set;                  // one cloud, or two: points and voxels
  std::uint64_t points = 0;      // in the strip
  std::uint64_t one_of = 1;      // one in so many is kept
  double low_m = 0, high_m = 0;  // their heights; low > high: there are none
};

/// Larger sections are thinned.
inline constexpr std::uint64_t kMostSectionPoints = 4'000'000;

/// Of the points within the heights. Empty if the line has no length or width, or is not finite.
Section cutThrough(const CloudSet& set, const Cut& cut, const HeightRange& heights,
                   const std::atomic<bool>* cancelled = nullptr);

/// The point of the section nearest to a position, within `reach_m`: (along, height).
std::optional<Eigen::Vector2d> nearestIn(const Section& section, const Eigen::Vector2d& at, double reach_m);

}  // namespace mapwright::clouds
