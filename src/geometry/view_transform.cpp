#include "geometry/view_transform.h"

#include <algorithm>
#include <cmath>

#include "geometry/pose.h"

namespace mapwright::geometry {

Eigen::Vector2d ViewTransform::pixelFromWorld(const Eigen::Vector2d& world_m) const {
  const double c = std::cos(rotation_rad), s = std::sin(rotation_rad);
  const Eigen::Vector2d d = (world_m - center_m) / scale_m_per_px;
  return {width_px / 2.0 + c * d.x() - s * d.y(), height_px / 2.0 - (s * d.x() + c * d.y())};
}

Eigen::Vector2d ViewTransform::worldFromPixelVector(const Eigen::Vector2d& pixels) const {
  const double c = std::cos(rotation_rad), s = std::sin(rotation_rad);
  const double right = pixels.x() * scale_m_per_px, up = -pixels.y() * scale_m_per_px;
  return {c * right + s * up, -s * right + c * up};
}

Eigen::Vector2d ViewTransform::worldFromPixel(const Eigen::Vector2d& pixel) const {
  return center_m + worldFromPixelVector({pixel.x() - width_px / 2.0, pixel.y() - height_px / 2.0});
}

WorldRect ViewTransform::visibleWorld() const {
  WorldRect rect;
  const double w = width_px, h = height_px;
  for (const auto& corner :
       {Eigen::Vector2d(0, 0), Eigen::Vector2d(w, 0), Eigen::Vector2d(0, h), Eigen::Vector2d(w, h)}) {
    rect.extend(worldFromPixel(corner));
  }
  return rect;
}

ViewTransform ViewTransform::zoomedAt(const Eigen::Vector2d& pixel, double factor) const {
  ViewTransform view = *this;
  view.scale_m_per_px = std::clamp(scale_m_per_px / factor, kMinScaleMPerPx, kMaxScaleMPerPx);
  view.center_m += worldFromPixel(pixel) - view.worldFromPixel(pixel);
  return view;
}

ViewTransform ViewTransform::rotatedAt(const Eigen::Vector2d& pixel, double by_rad) const {
  ViewTransform view = *this;
  view.rotation_rad = normalizeAngle(rotation_rad + by_rad);
  view.center_m += worldFromPixel(pixel) - view.worldFromPixel(pixel);
  return view;
}

ViewTransform ViewTransform::pannedBy(const Eigen::Vector2d& pixels) const {
  ViewTransform view = *this;
  view.center_m -= worldFromPixelVector(pixels);
  return view;
}

ViewTransform ViewTransform::fitted(const WorldRect& world, double margin_px) const {
  if (world.empty()) return *this;
  ViewTransform view = *this;
  view.center_m = world.center();
  const double c = std::abs(std::cos(rotation_rad)), s = std::abs(std::sin(rotation_rad));
  const double across = c * world.width() + s * world.height();
  const double along = s * world.width() + c * world.height();
  const double usable_w = std::max(1.0, width_px - 2 * margin_px);
  const double usable_h = std::max(1.0, height_px - 2 * margin_px);
  const double scale = std::max(across / usable_w, along / usable_h);
  if (scale > 0) view.scale_m_per_px = std::clamp(scale, kMinScaleMPerPx, kMaxScaleMPerPx);
  return view;
}

}  // namespace mapwright::geometry
