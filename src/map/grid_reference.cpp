#include "map/grid_reference.h"

#include <cmath>

#include "map/faults.h"

namespace mapwright::map {
namespace {

constexpr double kFinestM = 1e-4, kCoarsestM = 1e3, kFarthestM = 1e7;

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

std::optional<Fault> unusableReason(const GridReference& grid) {
  if (!std::isfinite(grid.resolution_m)) return fault::ResolutionNoNumber;
  if (grid.resolution_m <= 0) return Fault(fault::ResolutionNotPositive, {grid.resolution_m});
  if (grid.resolution_m < kFinestM || grid.resolution_m > kCoarsestM) {
    return Fault(fault::ResolutionOutOfBounds, {grid.resolution_m});
  }
  if (!std::isfinite(grid.origin.x_m) || !std::isfinite(grid.origin.y_m)) return fault::OriginNoNumber;
  if (std::abs(grid.origin.x_m) > kFarthestM || std::abs(grid.origin.y_m) > kFarthestM)
    return faultText("map", "Its origin is more than 10,000 km away, so it cannot be shown.");
  return std::nullopt;
}

}  // namespace mapwright::map
