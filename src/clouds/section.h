// A cloud cut along a line: the points of a strip, seen from the side. Pure.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

#include <Eigen/Core>

#include "clouds/cloud_book.h"

namespace mapwright::clouds {

/// Metres, in the map's frame. What lies within half of the width on either side of the line, from its start
/// to its end.
struct Cut {
  Eigen::Vector2d from_m{0, 0}, to_m{1, 0};
  double width_m = 0.5;
  double length() const { return (to_m - from_m).norm(); }
  bool operator==(const Cut&) const = default;
};

/// As points of a plane: x is how far along the line, y and z are the height. Their order is that of the set.
struct Section {
  Cut cut;
  CloudSet set;                  // one cloud, or two: points and voxels
  std::uint64_t points = 0;      // in the strip
  std::uint64_t one_of = 1;      // of how many one is held
  double low_m = 0, high_m = 0;  // their heights; low > high: there are none
};

/// More points than that are thinned.
inline constexpr std::uint64_t kMostSectionPoints = 4'000'000;

/// Of the points within the heights. A line without length or width, or whose numbers are not finite, has
/// none.
Section cutThrough(const CloudSet& set, const Cut& cut, const HeightRange& heights,
                   const std::atomic<bool>* cancelled = nullptr);

/// The point of the section nearest to a place in it, no farther than `reach_m`: (along, height).
std::optional<Eigen::Vector2d> nearestIn(const Section& section, const Eigen::Vector2d& at, double reach_m);

}  // namespace mapwright::clouds
