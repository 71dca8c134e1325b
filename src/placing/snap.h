// Snapping while dragging: what is close enough, and why. Pure; world metres.
#pragma once

#include <functional>
#include <vector>

#include "geometry/rect.h"
#include "placing/ground.h"

namespace mapwright::placing {

/// What to snap to.
struct SnapRules {
  bool waypoints = true;  // their positions, and lines through them along both axes
  bool grid = false;      // lines at multiples of `grid_m`
  bool walls = false;     // positions at `wall_m` from the nearest wall
  bool headings = true;   // multiples of kHeadingStep
  double grid_m = 0.5;    // above 0
  double wall_m = 0.5;    // positive, from the position to the wall
  bool operator==(const SnapRules&) const = default;
};

enum class Caught {
  Point,  // the very place of another waypoint
  LineX,  // its x is that of another waypoint
  LineY,
  GridX,  // its x is on a line of the grid
  GridY,
  Wall,  // it has the given distance from a wall
};

/// Why it snapped: a line from the reference to the snapped position.
struct Guide {
  Caught what = Caught::Point;
  Eigen::Vector2d from_m{0, 0}, to_m{0, 0};
};

struct SnappedPlace {
  Eigen::Vector2d at_m{0, 0};
  std::vector<Guide> guides;  // empty: nothing was caught
};

/// Calls back for each waypoint in a rectangle.
using Neighbours = std::function<void(const geometry::WorldRect& area,
                                      const std::function<void(const Eigen::Vector2d& at_m)>& found)>;

struct SnapScene {
  geometry::WorldRect seen;  // lines snap to what is in here
  double reach_m = 0;        // the snapping distance
  Neighbours others;         // may be empty
  Ground* ground = nullptr;  // null: there are no walls
};

/// Where `free_m` snaps to. Points take precedence over wall distances, and those over lines; along a wall
/// parallel to an axis, lines across it work as well. Among equals the nearest wins.
SnappedPlace snapped(const Eigen::Vector2d& free_m, const SnapRules& rules, const SnapScene& scene);

/// To the lines of a grid, at any distance.
Eigen::Vector2d onGrid(const Eigen::Vector2d& at_m, double step_m);

inline constexpr double kHeadingStepDeg = 15;
/// The nearest multiple of 15 degrees within `reach_rad`, otherwise the heading itself.
double snappedHeading(double yaw_rad, double reach_rad);

}  // namespace mapwright::placing
