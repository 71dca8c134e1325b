// Arranges waypoints as a group: rotate, place along a line, align, distribute; and names for new ones. Pure
// functions; world metres, radians counter-clockwise.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace mapwright::placing {

struct Spot {
  Eigen::Vector2d position_m{0, 0};
  std::optional<double> yaw_rad = {};
  bool operator==(const Spot&) const = default;
};

/// The mean of their positions, which rotation around it preserves; (0, 0) for none.
Eigen::Vector2d middleOf(const std::vector<Spot>& spots);

/// Rotates all around `pivot_m`, including their headings.
std::vector<Spot> turned(std::vector<Spot> spots, const Eigen::Vector2d& pivot_m, double by_rad);

/// The maximum number of waypoints on one line.
inline constexpr std::size_t kMostAlongLine = 2000;

/// Starts at `from_m`, with one every `spacing_m`, not beyond `to_m`; all head along the line. Empty if it
/// has no length, the spacing is not positive, or there would be more than kMostAlongLine.
std::vector<Spot> alongLine(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m, double spacing_m);

enum class Axis { X, Y };
/// Moves all to the middle of their range on that axis.
std::vector<Spot> aligned(std::vector<Spot> spots, Axis axis);
/// The outermost two stay; the others are spaced evenly between them along that axis, in their present order.
std::vector<Spot> distributed(std::vector<Spot> spots, Axis axis);

/// "Rack 3" -> "Rack 4", "Dock" -> "Dock 2": the next free name, which is taken then.
std::string nextName(const std::string& name, std::set<std::string>& taken);

}  // namespace mapwright::placing
