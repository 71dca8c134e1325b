// Relations of adjacent squares and rectangles.
#pragma once

#include <algorithm>
#include <array>

#include "regions/region_lattice.h"

namespace mapwright::regions {

enum class Side { Left, Right, Bottom, Top };
inline constexpr std::array kSides{Side::Left, Side::Right, Side::Bottom, Side::Top};

inline std::size_t at(Side side) { return std::size_t(side); }

inline RegionKey besideOf(const RegionKey& key, Side side) {
  switch (side) {
    case Side::Left:
      return {key.x - 1, key.y};
    case Side::Right:
      return {key.x + 1, key.y};
    case Side::Bottom:
      return {key.x, key.y - 1};
    case Side::Top:
      break;
  }
  return {key.x, key.y + 1};
}

inline double endOf(const geometry::WorldRect& rect, Side side) {
  switch (side) {
    case Side::Left:
      return rect.min_x;
    case Side::Right:
      return rect.max_x;
    case Side::Bottom:
      return rect.min_y;
    case Side::Top:
      break;
  }
  return rect.max_y;
}

/// `known`, which is in `square`, reaches its edge on that side.
inline bool reaches(const geometry::WorldRect& known, const geometry::WorldRect& square, Side side,
                    double slack) {
  const bool upwards = side == Side::Right || side == Side::Top;
  return upwards ? endOf(known, side) >= endOf(square, side) - slack
                 : endOf(known, side) <= endOf(square, side) + slack;
}

inline geometry::WorldRect common(const geometry::WorldRect& a, const geometry::WorldRect& b) {
  return {std::max(a.min_x, b.min_x), std::max(a.min_y, b.min_y), std::min(a.max_x, b.max_x),
          std::min(a.max_y, b.max_y)};
}

}  // namespace mapwright::regions
