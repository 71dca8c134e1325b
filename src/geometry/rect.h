// Axis-aligned rectangles in world metres, y up.
#pragma once

#include <algorithm>
#include <limits>

#include <Eigen/Core>

namespace mapwright::geometry {

/// A closed axis-aligned rectangle in world metres. The default one is empty: extending it by a point gives
/// that point.
struct WorldRect {
  double min_x = std::numeric_limits<double>::infinity();
  double min_y = std::numeric_limits<double>::infinity();
  double max_x = -std::numeric_limits<double>::infinity();
  double max_y = -std::numeric_limits<double>::infinity();
  bool operator==(const WorldRect&) const = default;

  bool empty() const { return min_x > max_x || min_y > max_y; }
  double width() const { return empty() ? 0 : max_x - min_x; }
  double height() const { return empty() ? 0 : max_y - min_y; }
  Eigen::Vector2d center() const { return {(min_x + max_x) / 2, (min_y + max_y) / 2}; }

  void extend(const Eigen::Vector2d& p) {
    min_x = std::min(min_x, p.x());
    min_y = std::min(min_y, p.y());
    max_x = std::max(max_x, p.x());
    max_y = std::max(max_y, p.y());
  }
  void extend(const WorldRect& other) {
    if (other.empty()) return;
    extend(Eigen::Vector2d(other.min_x, other.min_y));
    extend(Eigen::Vector2d(other.max_x, other.max_y));
  }
  WorldRect grown(double by_m) const { return {min_x - by_m, min_y - by_m, max_x + by_m, max_y + by_m}; }
  bool intersects(const WorldRect& o) const {
    return !empty() && !o.empty() && min_x <= o.max_x && o.min_x <= max_x && min_y <= o.max_y &&
           o.min_y <= max_y;
  }
  bool contains(const Eigen::Vector2d& p) const {
    return p.x() >= min_x && p.x() <= max_x && p.y() >= min_y && p.y() <= max_y;
  }
};

}  // namespace mapwright::geometry
