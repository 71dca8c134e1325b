// Overlays as a group: put in line, spaced evenly; outlines of circles. Pure functions; world metres.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "geometry/rect.h"

namespace mapwright::overlays {

enum class Alignment { Left, CentreX, Right, Top, CentreY, Bottom };
enum class Spread { X, Y };

/// By how much each has to move, in the order of the boxes, so that all have this edge or middle of the box
/// around them.
std::vector<Eigen::Vector2d> shiftsToAlign(const std::vector<geometry::WorldRect>& boxes, Alignment how);
/// So that the gaps between neighbours are equal; the outermost two stay. Fewer than three stay, too.
std::vector<Eigen::Vector2d> shiftsToSpread(const std::vector<geometry::WorldRect>& boxes, Spread along);

inline constexpr int kCircleVertices = 32;
std::vector<Eigen::Vector2d> circleAround(const Eigen::Vector2d& centre_m, double radius_m);

}  // namespace mapwright::overlays
