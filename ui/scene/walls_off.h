// Walls of a reference map and of the map on screen that are far from those of the other one, as marks: a
// bent corridor is seen by them.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>
#include <QColor>

namespace mapwright::ui::scene {

/// How far walls may be off before they are marked otherwise.
inline constexpr std::array<double, 3> kOffSteps_m{0.1, 0.3, 1};
/// The look of a step: colours differ in lightness, and marks in size.
QColor offColor(std::size_t step);
inline constexpr std::array<double, 3> kOffMarks_px{3, 5, 8};

/// A cell of a wall.
struct OffWall {
  Eigen::Vector2d at_m{0, 0};  // world
  double off_m = 0;            // to the nearest wall of the other map
};
struct WallsOff {
  std::vector<OffWall> walls;
  double cell_m = 0;  // the edge of a cell
};

}  // namespace mapwright::ui::scene
