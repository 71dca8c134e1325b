// Where in the world the things of a layer lie. Private to this room.
#pragma once

#include <Eigen/Core>

#include "geometry/rect.h"
#include "scene/layer_item.h"

namespace mapwright::scene {

/// A point that is not finite adds nothing.
inline void extendBy(geometry::WorldRect& bounds, const Eigen::Vector2d& point) {
  if (point.allFinite()) bounds.extend(point);
}

template <class Points>
geometry::WorldRect boundsOf(const Points& points) {
  geometry::WorldRect bounds;
  for (const Eigen::Vector2d& point : points) extendBy(bounds, point);
  return bounds;
}

/// Of the submaps that are shown.
inline geometry::WorldRect boundsOf(const Outlines& outlines) {
  geometry::WorldRect bounds;
  for (const auto& [id, outline] : outlines) {
    if (!outline.visible) continue;
    for (const Eigen::Vector2d& corner : outline.corners) extendBy(bounds, corner);
  }
  return bounds;
}

}  // namespace mapwright::scene
