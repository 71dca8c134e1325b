#include "simulator/floor_plan.h"

#include <algorithm>
#include <cmath>

namespace mapwright::simulator {
namespace {

constexpr double kCornerCutM = 0.7;   // how far before a corner the turn begins
constexpr double kLookAheadM = 0.18;  // heading is that of the chord around the robot
constexpr int kCornerPoints = 8;
constexpr double kGridM = 4.0;

}  // namespace

Eigen::Vector2d Solid::extent() const {
  if (round) return {half.x(), half.x()};
  const double c = std::abs(std::cos(yaw_rad)), s = std::abs(std::sin(yaw_rad));
  return {c * half.x() + s * half.y(), s * half.x() + c * half.y()};
}

double Solid::distanceTo(const Eigen::Vector2d& point) const {
  const Eigen::Vector2d offset = point - centre;
  if (round) return offset.norm() - half.x();
  const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
  const double dx = std::abs(c * offset.x() + s * offset.y()) - half.x();
  const double dy = std::abs(-s * offset.x() + c * offset.y()) - half.y();
  return std::hypot(std::max(dx, 0.0), std::max(dy, 0.0)) + std::min(std::max(dx, dy), 0.0);
}

FloorPlan::FloorPlan(std::vector<Solid> solids) : solids_(std::move(solids)) {
  if (solids_.empty()) return;
  Eigen::Vector2d low = solids_.front().centre, high = low;
  for (const Solid& solid : solids_) {
    low = low.cwiseMin(solid.centre - solid.extent());
    high = high.cwiseMax(solid.centre + solid.extent());
  }
  origin_ = low;
  columns_ = static_cast<int>((high.x() - low.x()) / kGridM) + 1;
  rows_ = static_cast<int>((high.y() - low.y()) / kGridM) + 1;

  std::vector<std::uint32_t> counts(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1,
                                    0);
  const auto visit = [&](const Solid& solid, auto&& action) {
    const Span span = cellsOf(solid.centre - solid.extent(), solid.centre + solid.extent());
    for (int y = span.y0; y <= span.y1; ++y) {
      for (int x = span.x0; x <= span.x1; ++x) {
        action(static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(x));
      }
    }
  };
  for (const Solid& solid : solids_) {
    visit(solid, [&](std::size_t cell) { ++counts[cell + 1]; });
  }
  for (std::size_t i = 1; i < counts.size(); ++i) counts[i] += counts[i - 1];
  starts_ = counts;
  members_.resize(counts.back());
  for (std::uint32_t i = 0; i < solids_.size(); ++i) {
    visit(solids_[i], [&](std::size_t cell) { members_[counts[cell]++] = i; });
  }
}

FloorPlan::Span FloorPlan::cellsOf(const Eigen::Vector2d& low, const Eigen::Vector2d& high) const {
  const auto cell = [](double offset, int count) {
    return static_cast<int>(std::clamp(std::floor(offset / kGridM), 0.0, static_cast<double>(count - 1)));
  };
  return {cell(low.x() - origin_.x(), columns_), cell(low.y() - origin_.y(), rows_),
          cell(high.x() - origin_.x(), columns_), cell(high.y() - origin_.y(), rows_)};
}

std::vector<std::uint32_t> FloorPlan::near(const Eigen::Vector2d& low, const Eigen::Vector2d& high) const {
  std::vector<std::uint32_t> found;
  if (solids_.empty()) return found;
  const Span span = cellsOf(low, high);
  for (int y = span.y0; y <= span.y1; ++y) {
    const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_);
    const auto first = members_.begin() + starts_[row + static_cast<std::size_t>(span.x0)];
    const auto last = members_.begin() + starts_[row + static_cast<std::size_t>(span.x1) + 1];
    found.insert(found.end(), first, last);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

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
