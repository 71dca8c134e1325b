// The camera: converts world metres (y up) to pixels (y down), for the window and for snapshots.
#pragma once

#include <Eigen/Core>

#include "geometry/rect.h"

namespace mapwright::geometry {

/// A view of the plane. Pixel (0,0)'s corner is the top left; pixel coordinates are continuous, so the centre
/// of the first pixel is (0.5, 0.5).
///
/// pixel = size/2 + R * (world - center) / scale with y flipped; rotation_rad > 0 turns the picture
/// counter-clockwise. Unrotated, pixel (0,0)'s corner lies at world (center.x - w/2*scale, center.y +
/// h/2*scale) (docs/command-line.md, "mapwright snapshot").
struct ViewTransform {
  Eigen::Vector2d center_m{0, 0};
  double scale_m_per_px = 0.05;
  double rotation_rad = 0;
  int width_px = 1;
  int height_px = 1;
  bool operator==(const ViewTransform&) const = default;

  Eigen::Vector2d pixelFromWorld(const Eigen::Vector2d& world_m) const;
  Eigen::Vector2d worldFromPixel(const Eigen::Vector2d& pixel) const;
  /// The world displacement of a pixel displacement.
  Eigen::Vector2d worldFromPixelVector(const Eigen::Vector2d& pixels) const;

  /// The smallest axis-aligned world rectangle that contains the whole view.
  WorldRect visibleWorld() const;

  /// Zooms by `factor` (> 1 magnifies) around the world point under `pixel`.
  ViewTransform zoomedAt(const Eigen::Vector2d& pixel, double factor) const;
  /// Rotates by `by_rad` counter-clockwise around the world point under `pixel`.
  ViewTransform rotatedAt(const Eigen::Vector2d& pixel, double by_rad) const;
  /// Moves the view so that the picture follows a drag by `pixels`.
  ViewTransform pannedBy(const Eigen::Vector2d& pixels) const;
  /// Same size and rotation, showing all of `world` with a margin of `margin_px`. An empty rectangle changes
  /// nothing.
  ViewTransform fitted(const WorldRect& world, double margin_px) const;
};

/// The functions above clamp the scale to this range: 0.1 mm to 100 km per pixel.
inline constexpr double kMinScaleMPerPx = 1e-4;
inline constexpr double kMaxScaleMPerPx = 1e5;

}  // namespace mapwright::geometry
