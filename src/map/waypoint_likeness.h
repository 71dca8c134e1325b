// When two places or headings are the same. Numbers that went to a robot or into a file come back a little
// different (a heading as a quaternion, decimals cut off): the one tolerance for all who compare them. Pure.
#pragma once

#include <optional>

#include <Eigen/Core>

namespace mapwright::map {

inline constexpr double kSameM = 1e-4, kSameRad = 1e-4;

bool samePlace(const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m);
/// Radians; whole turns more or less are the same.
bool sameHeading(double a_rad, double b_rad);
/// None is another heading than any other.
bool sameHeading(const std::optional<double>& a_rad, const std::optional<double>& b_rad);

}  // namespace mapwright::map
