// Camera moves: the zoom ladder and the animation between two views. Pure.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "geometry/view_transform.h"

namespace mapwright::window {

inline constexpr double kLadder = 1.25;             // one wheel notch
inline constexpr double kNativeScaleMPerPx = 0.05;  // 1:1, a usual cell of a robot's map

/// The scale `steps` rungs from `scale` (positive magnifies). Whole steps snap to the ladder 0.05 * 1.25^k,
/// so that 1:1 is one of them; fractional steps do not snap.
double ladderScale(double scale_m_per_px, double steps);

/// An animation from one view to another, evaluated by `at(t)`, t in 0..1.
struct CameraMotion {
  geometry::ViewTransform from, to;
  /// The pixel whose world point stays fixed; nullopt = move straight.
  std::optional<Eigen::Vector2d> anchor;

  geometry::ViewTransform at(double t) const;
};

}  // namespace mapwright::window
