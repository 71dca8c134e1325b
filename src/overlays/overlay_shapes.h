// Where a feature lies: its points in metres of the map. Source: RFC 7946; docs/protocols/autoxing.md,
// "Overlays".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "overlays/overlay_document.h"

namespace mapwright::overlays {

/// Beyond this no coordinate is meant (metres).
inline constexpr double kFarthestM = 1e7;

/// A point, a line, or a ring of a polygon without its closing point. Multi… and collections are several.
struct Path {
  Shape shape = Shape::Point;
  std::vector<Eigen::Vector2d> points;  // finite; without the unusable ones
  int polygon = -1;                     // rings of the same polygon have the same number, the outer one first
};

struct Shapes {
  std::vector<Path> paths;
  std::optional<std::string> bad;      // the first coordinate that cannot be used, as written
  std::optional<std::string> unknown;  // the first type of geometry that is none

  std::optional<Eigen::Vector2d> somewhere() const;
};
Shapes shapesOf(const Feature& feature);

/// properties.yaw, a number or a text, in degrees; nullopt: none, or none that can be used.
std::optional<double> yawOf(const Feature& feature);

/// Twice the area with its sign.
double doubleArea(const std::vector<Eigen::Vector2d>& ring);
/// Where an outline crosses itself or runs back along itself; touching in a point is allowed.
std::optional<Eigen::Vector2d> selfCrossing(const std::vector<Eigen::Vector2d>& ring);

}  // namespace mapwright::overlays
