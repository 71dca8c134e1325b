// Divides the plane into squares that are requested one after the other. Pure values, any thread.
#pragma once

#include <compare>
#include <cstdint>
#include <functional>

#include "geometry/rect.h"
#include "map/map_part.h"

namespace mapwright::regions {

/// A square of a lattice: x to the right, y upwards.
struct RegionKey {
  std::int64_t x = 0, y = 0;
  auto operator<=>(const RegionKey&) const = default;
};

/// Squares along the axes of the map's frame. Metres.
struct RegionLattice {
  Eigen::Vector2d anchor_m{0, 0};  // the lower left corner of square (0, 0)
  double edge_m = 51.2;            // finite, greater than 0
  bool operator==(const RegionLattice&) const = default;

  geometry::WorldRect rectOf(const RegionKey& key) const;
  /// The squares that overlap `rect` (finite) by more than an edge: their number, and each of them.
  double countIn(const geometry::WorldRect& rect) const;
  void eachIn(const geometry::WorldRect& rect, const std::function<void(const RegionKey&)>& each) const;

 private:
  struct Range {
    double x0, y0, x1, y1;  // integers, inclusive
  };
  Range rangeOf(const geometry::WorldRect& rect) const;
};

/// The request for a rectangle.
map::GridRegion askedFor(const geometry::WorldRect& rect);

bool isFinite(const geometry::WorldRect& rect);

}  // namespace mapwright::regions
