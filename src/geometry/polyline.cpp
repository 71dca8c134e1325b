#include "geometry/polyline.h"

#include <algorithm>
#include <cmath>

namespace mapwright::geometry {

double lengthOf(std::span<const Eigen::Vector2d> line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  return length;
}

double signedAreaOf(std::span<const Eigen::Vector2d> ring) {
  if (ring.empty()) return 0;
  double twice = 0;
  // From the first point, so that a small ring far away keeps its precision.
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const Eigen::Vector2d a = ring[i] - ring[0], b = ring[i + 1] - ring[0];
    twice += a.x() * b.y() - b.x() * a.y();
  }
  return twice / 2;
}

double angleAt(const Eigen::Vector2d& corner, const Eigen::Vector2d& before, const Eigen::Vector2d& after) {
  const Eigen::Vector2d a = before - corner, b = after - corner;
  return std::abs(std::atan2(a.x() * b.y() - b.x() * a.y(), a.dot(b)));
}

double distanceToSegment(const Eigen::Vector2d& point, const Eigen::Vector2d& from,
                         const Eigen::Vector2d& to) {
  const Eigen::Vector2d along = to - from;
  const double squared = along.squaredNorm();
  const double t = squared > 0 ? std::clamp((point - from).dot(along) / squared, 0.0, 1.0) : 0;
  return (from + t * along - point).norm();
}

}  // namespace mapwright::geometry
