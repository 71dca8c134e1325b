#include "simulator/floor_plan.h"

#include <algorithm>
#include <cmath>

namespace mapwright::simulator {
namespace {

constexpr double kGridM = 4.0;

Eigen::Vector2d extentOf(const Solid& solid) {
  if (solid.round) return {solid.half.x(), solid.half.x()};
  const double c = std::abs(std::cos(solid.yaw_rad)), s = std::abs(std::sin(solid.yaw_rad));
  return {c * solid.half.x() + s * solid.half.y(), s * solid.half.x() + c * solid.half.y()};
}

}  // namespace

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
    low = low.cwiseMin(solid.centre - extentOf(solid));
    high = high.cwiseMax(solid.centre + extentOf(solid));
  }
  origin_ = low;
  columns_ = static_cast<int>((high.x() - low.x()) / kGridM) + 1;
  rows_ = static_cast<int>((high.y() - low.y()) / kGridM) + 1;

  std::vector<std::uint32_t> counts(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1,
                                    0);
  const auto visit = [&](const Solid& solid, auto&& action) {
    const Span span = cellsOf(solid.centre - extentOf(solid), solid.centre + extentOf(solid));
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

}  // namespace mapwright::simulator
