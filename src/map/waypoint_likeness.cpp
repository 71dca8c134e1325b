#include "map/waypoint_likeness.h"

#include <cmath>

#include "geometry/pose.h"

namespace mapwright::map {

bool samePlace(const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m) {
  return (a_m - b_m).norm() <= kSameM;
}

bool sameHeading(double a_rad, double b_rad) {
  return std::abs(geometry::normalizeAngle(a_rad - b_rad)) <= kSameRad;
}

bool sameHeading(const std::optional<double>& a_rad, const std::optional<double>& b_rad) {
  return a_rad && b_rad ? sameHeading(*a_rad, *b_rad) : a_rad.has_value() == b_rad.has_value();
}

}  // namespace mapwright::map
