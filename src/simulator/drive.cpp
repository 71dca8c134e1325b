#include "simulator/drive.h"

#include <algorithm>
#include <cmath>

namespace mapwright::simulator {
namespace {

constexpr double kCornerCutM = 0.7;   // how far before a corner the turn begins
constexpr double kLookAheadM = 0.18;  // heading is that of the chord around the robot
constexpr int kCornerPoints = 8;

}  // namespace

Drive::Drive(const std::vector<Eigen::Vector2d>& waypoints, bool closed) : closed_(closed) {
  std::vector<Eigen::Vector2d> corners;
  for (const Eigen::Vector2d& point : waypoints) {
    if (corners.empty() || (point - corners.back()).norm() > 1e-6) corners.push_back(point);
  }
  if (closed && corners.size() > 1 && (corners.front() - corners.back()).norm() < 1e-6) corners.pop_back();
  if (corners.empty()) return;

  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (!closed && (i == 0 || i + 1 == n)) {
      points_.push_back(corners[i]);
      continue;
    }
    const Eigen::Vector2d& corner = corners[i];
    const Eigen::Vector2d in = corners[(i + n - 1) % n] - corner;
    const Eigen::Vector2d out = corners[(i + 1) % n] - corner;
    const double cut = std::min({kCornerCutM, 0.48 * in.norm(), 0.48 * out.norm()});
    const Eigen::Vector2d from = corner + in.normalized() * cut, to = corner + out.normalized() * cut;
    for (int k = 0; k <= kCornerPoints; ++k) {
      const double t = static_cast<double>(k) / kCornerPoints;
      points_.emplace_back((1 - t) * (1 - t) * from + 2 * t * (1 - t) * corner + t * t * to);
    }
  }
  if (closed) points_.push_back(points_.front());

  along_.reserve(points_.size());
  double length = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (i > 0) length += (points_[i] - points_[i - 1]).norm();
    along_.push_back(length);
  }
}

Eigen::Vector2d Drive::pointAt(double s) const {
  const double length = length_m();
  if (points_.empty()) return {0, 0};
  if (length <= 0) return points_.front();
  if (closed_) {
    s = std::fmod(s, length);
    if (s < 0) s += length;
  }
  s = std::clamp(s, 0.0, length);
  const auto after = std::upper_bound(along_.begin(), along_.end(), s);
  if (after == along_.end()) return points_.back();
  const auto i = static_cast<std::size_t>(after - along_.begin());
  const double step = along_[i] - along_[i - 1];
  const double t = step > 0 ? (s - along_[i - 1]) / step : 0;
  return points_[i - 1] + t * (points_[i] - points_[i - 1]);
}

geometry::Pose2 Drive::at(double s) const {
  if (!closed_) s = std::clamp(s, 0.0, length_m());
  const Eigen::Vector2d here = pointAt(s);
  const Eigen::Vector2d chord = pointAt(s + kLookAheadM) - pointAt(s - kLookAheadM);
  return {here.x(), here.y(), chord.norm() > 1e-9 ? std::atan2(chord.y(), chord.x()) : 0.0};
}

}  // namespace mapwright::simulator
