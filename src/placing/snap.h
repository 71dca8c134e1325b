// Where something lets go that is moved by hand: what is near enough to be caught, and why. Pure; world
// metres.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "geometry/rect.h"
#include "placing/ground.h"

namespace mapwright::placing {

/// What there is to be caught.
struct SnapRules {
  bool waypoints = true;  // their places, and lines through them along both axes
  bool grid = false;      // lines at multiples of `grid_m`
  bool walls = false;     // places at `wall_m` from the nearest wall
  bool headings = true;   // multiples of kHeadingStep
  double grid_m = 0.5;    // above 0
  double wall_m = 0.5;    // above 0, from the place to the wall
  bool operator==(const SnapRules&) const = default;
};

enum class Caught {
  Point,  // the very place of another waypoint
  LineX,  // its x is that of another waypoint
  LineY,
  GridX,  // its x is on a line of the grid
  GridY,
  Wall,  // it has the distance from a wall that was asked for
};

/// Why: from what was caught to where it holds it.
struct Guide {
  Caught what = Caught::Point;
  Eigen::Vector2d from_m{0, 0}, to_m{0, 0};
};

struct SnappedPlace {
  Eigen::Vector2d at_m{0, 0};
  std::vector<Guide> guides;  // empty: nothing was caught
};

/// Other waypoints in a rectangle, one call each.
using Neighbours = std::function<void(const geometry::WorldRect& area,
                                      const std::function<void(const Eigen::Vector2d& at_m)>& found)>;

struct SnapScene {
  geometry::WorldRect seen;  // lines are caught from what is in here
  double reach_m = 0;        // that of the hand
  Neighbours others;         // may be empty
  Ground* ground = nullptr;  // null: there are no walls
};

/// The place that `free_m` is caught at. A point is caught before a distance to a wall, that before lines;
/// along a wall that runs with an axis, lines across it are caught as well. Of several alike the nearest one
/// is.
SnappedPlace snapped(const Eigen::Vector2d& free_m, const SnapRules& rules, const SnapScene& scene);

/// To the lines of a grid, however far they are.
Eigen::Vector2d onGrid(const Eigen::Vector2d& at_m, double step_m);

inline constexpr double kHeadingStepDeg = 15;
/// The heading that is caught: the nearest multiple of 15 degrees within `reach_rad`, else itself.
double snappedHeading(double yaw_rad, double reach_rad);

}  // namespace mapwright::placing
