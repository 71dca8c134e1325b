#include "map/grid_reference.h"

#include <cmath>
#include <cstdio>

namespace mapwright::map {
namespace {

constexpr double kFinestM = 1e-4, kCoarsestM = 1e3, kFarthestM = 1e7;

std::string plain(double number) {
  char text[40];
  std::snprintf(text, sizeof text, "%g", number);
  return text;
}

}  // namespace

Eigen::Vector2d GridReference::worldFromCell(const Eigen::Vector2d& cell) const {
  return origin.apply({cell.x() * resolution_m, (height - cell.y()) * resolution_m});
}

Eigen::Vector2d GridReference::cellFromWorld(const Eigen::Vector2d& world_m) const {
  const Eigen::Vector2d local = origin.inverse().apply(world_m) / resolution_m;
  return {local.x(), height - local.y()};
}

geometry::WorldRect GridReference::bounds() const {
  geometry::WorldRect rect;
  if (width <= 0 || height <= 0) return rect;
  for (const double x : {0.0, double(width)}) {
    for (const double y : {0.0, double(height)}) rect.extend(worldFromCell({x, y}));
  }
  return rect;
}

std::optional<std::string> whyUnusable(const GridReference& grid) {
  if (!std::isfinite(grid.resolution_m)) return "Its resolution is not a number, so it cannot be placed.";
  if (grid.resolution_m <= 0) {
    return "Its resolution is " + plain(grid.resolution_m) + ", which is no size of a cell.";
  }
  if (grid.resolution_m < kFinestM || grid.resolution_m > kCoarsestM) {
    return "Its resolution of " + plain(grid.resolution_m) +
           " m is out of bounds: between 0.1 mm and 1 km can be shown.";
  }
  if (!std::isfinite(grid.origin.x_m) || !std::isfinite(grid.origin.y_m)) {
    return "Its origin is missing or not a number, so it cannot be placed.";
  }
  if (std::abs(grid.origin.x_m) > kFarthestM || std::abs(grid.origin.y_m) > kFarthestM) {
    return "Its origin lies farther than 10,000 km away, so it cannot be placed.";
  }
  return std::nullopt;
}

}  // namespace mapwright::map
