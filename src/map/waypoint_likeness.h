// When two positions or headings are equal. Numbers sent to a robot or written to a file come back slightly
// different (a heading as a quaternion, truncated decimals): the one tolerance for all comparisons. Pure.
#pragma once

#include <optional>

#include <Eigen/Core>

namespace mapwright::map {

inline constexpr double kSameM = 1e-4, kSameRad = 1e-4;

bool samePlace(const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m);
/// Radians, modulo full turns.
bool sameHeading(double a_rad, double b_rad);
/// No heading differs from any heading.
bool sameHeading(const std::optional<double>& a_rad, const std::optional<double>& b_rad);

}  // namespace mapwright::map
