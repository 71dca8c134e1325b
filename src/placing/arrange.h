// Waypoints as a group: turned, set along a line, put in line, evenly apart. Pure functions; world metres,
// radians counter-clockwise.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace mapwright::placing {

struct Spot {
  Eigen::Vector2d position_m{0, 0};
  std::optional<double> yaw_rad = {};
  bool operator==(const Spot&) const = default;
};

/// The mean of their places, which stays where it is however they are turned about it; (0, 0) of none.
Eigen::Vector2d middleOf(const std::vector<Spot>& spots);

/// All turned about `pivot_m`; their headings turn with them.
std::vector<Spot> turned(std::vector<Spot> spots, const Eigen::Vector2d& pivot_m, double by_rad);

std::vector<Spot> shifted(std::vector<Spot> spots, const Eigen::Vector2d& by_m);

/// So many at most come of one line.
inline constexpr std::size_t kMostAlongLine = 2000;

/// From `from_m` on, one every `spacing_m`, the last one not beyond `to_m`; all head along the line. Empty
/// when it has no length, or the spacing is not above zero, or there would be more than kMostAlongLine.
std::vector<Spot> alongLine(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m, double spacing_m);

enum class Axis { X, Y };
/// All on one value of that axis: the middle of their range.
std::vector<Spot> aligned(std::vector<Spot> spots, Axis axis);
/// The outermost two stay; the others lie evenly between them along that axis, in the order that they have.
std::vector<Spot> distributed(std::vector<Spot> spots, Axis axis);

}  // namespace mapwright::placing
