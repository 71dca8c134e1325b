// Arranges waypoints as a group: rotate, mirror, place along a line, align, distribute, head along a way; in
// which order they lie; and names for copies. Pure functions; world metres, radians counter-clockwise.
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

/// Mirrors all, including their headings, about the line through `through_m` in that direction.
std::vector<Spot> mirrored(std::vector<Spot> spots, const Eigen::Vector2d& through_m, double along_rad);

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

enum class LastHeads {
  OnAsBefore,   // like the one before it
  BackToFirst,  // the way is a loop
};
/// Each heads towards the next. Those that lie in one place head to the next one elsewhere; where there is
/// none, headings stay.
std::vector<Spot> headingOn(std::vector<Spot> spots, LastHeads last);

enum class Order { AsGiven, X, Y, AlongLine };
/// Their indices in that order. AlongLine: along the line that fits them best, towards larger x, or larger y
/// where it is vertical.
std::vector<std::size_t> orderOf(const std::vector<Spot>& spots, Order order);

/// The middle of the rectangle around them; (0, 0) for none.
Eigen::Vector2d centreOf(const std::vector<Spot>& spots);

/// "Rack 3" -> "Rack 4", "Dock" -> "Dock 2": the next free name, which is taken then.
std::string nextName(const std::string& name, std::set<std::string>& taken);

}  // namespace mapwright::placing
