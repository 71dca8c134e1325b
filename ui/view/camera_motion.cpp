#include "ui/view/camera_motion.h"

#include <algorithm>
#include <cmath>

#include "geometry/pose.h"

namespace mapwright::window {

double ladderScale(double scale_m_per_px, double steps) {
  using geometry::kMaxScaleMPerPx;
  using geometry::kMinScaleMPerPx;
  double rung = std::log(kNativeScaleMPerPx / scale_m_per_px) / std::log(kLadder);
  if (steps == std::round(steps)) {
    // Between two rungs, the first step goes to the next rung in its direction.
    const double near = std::round(rung);
    if (std::abs(rung - near) < 1e-6) rung = near;
    rung = steps > 0 ? std::floor(rung) : std::ceil(rung);
  }
  const double scale = kNativeScaleMPerPx / std::pow(kLadder, rung + steps);
  return std::clamp(scale, kMinScaleMPerPx, kMaxScaleMPerPx);
}

geometry::ViewTransform CameraMotion::at(double t) const {
  if (t >= 1) return to;
  const double eased = 1 - (1 - t) * (1 - t);
  const double turn = geometry::normalizeAngle(to.rotation_rad - from.rotation_rad);
  const double zoom = from.scale_m_per_px / to.scale_m_per_px;
  if (anchor) {
    geometry::ViewTransform view = from.zoomedAt(*anchor, std::pow(zoom, eased));
    return turn == 0 ? view : view.rotatedAt(*anchor, turn * eased);
  }
  geometry::ViewTransform view = to;
  view.scale_m_per_px = from.scale_m_per_px / std::pow(zoom, eased);
  view.rotation_rad = geometry::normalizeAngle(from.rotation_rad + turn * eased);
  view.center_m = from.center_m + (to.center_m - from.center_m) * eased;
  return view;
}

}  // namespace mapwright::window
