#include "overlays/overlay_snap.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mapwright::overlays {
namespace {

using Eigen::Vector2d;

constexpr double kLeastCellM = 0.5;
constexpr double kMostSnapCells = 1024;  // along the longer side of all
constexpr int kMostAround = 64;          // cells in each direction of a query

Vector2d nearestOn(const SnapIndex::Side& side, const Vector2d& at) {
  const Vector2d along = side.to_m - side.from_m;
  const double length2 = along.squaredNorm();
  if (length2 == 0) return side.from_m;
  return side.from_m + along * std::clamp((at - side.from_m).dot(along) / length2, 0.0, 1.0);
}

std::int64_t cellOf(std::int32_t column, std::int32_t row) {
  return (std::int64_t(column) << 32) ^ std::int64_t(std::uint32_t(row));
}

}  // namespace

std::int32_t SnapIndex::columnOf(double metres) const {
  return std::int32_t(std::floor(std::clamp(metres / cell_m_, -2e9, 2e9)));
}

void SnapIndex::add(FeatureKey key, const std::vector<Path>& paths) {
  for (const Path& path : paths) {
    const auto& points = path.points;
    if (points.empty()) continue;
    if (path.shape == Shape::Point || points.size() == 1) {
      sides_.push_back({points[0], points[0], key});
      continue;
    }
    const std::size_t count = path.shape == Shape::Polygon ? points.size() : points.size() - 1;
    for (std::size_t i = 0; i < count; ++i)
      sides_.push_back({points[i], points[(i + 1) % points.size()], key});
  }
}

void SnapIndex::finish() {
  Vector2d low(HUGE_VAL, HUGE_VAL), high(-HUGE_VAL, -HUGE_VAL);
  for (const Side& side : sides_) {
    low = low.cwiseMin(side.from_m).cwiseMin(side.to_m);
    high = high.cwiseMax(side.from_m).cwiseMax(side.to_m);
  }
  by_cell_.clear();
  if (sides_.empty()) return;
  cell_m_ = std::max(kLeastCellM, (high - low).maxCoeff() / kMostSnapCells);
  by_cell_.reserve(sides_.size());
  for (std::uint32_t i = 0; i < sides_.size(); ++i) {
    const Side& side = sides_[i];
    // Row by row: the columns that it crosses there.
    const Vector2d &a = side.from_m.y() <= side.to_m.y() ? side.from_m : side.to_m,
                   &b = side.from_m.y() <= side.to_m.y() ? side.to_m : side.from_m;
    const std::int32_t first = columnOf(a.y()), last = columnOf(b.y());
    for (std::int32_t row = first; row <= last; ++row) {
      const double rise = b.y() - a.y();
      const auto xAt = [&](double y) {
        return rise > 0 ? a.x() + (b.x() - a.x()) * std::clamp((y - a.y()) / rise, 0.0, 1.0) : a.x();
      };
      double from = xAt(row * cell_m_), to = xAt((row + 1) * cell_m_);
      if (first == last) {
        from = a.x();
        to = b.x();
      }
      if (from > to) std::swap(from, to);
      for (std::int32_t column = columnOf(from); column <= columnOf(to); ++column)
        by_cell_[cellOf(column, row)].push_back(i);
    }
  }
}

template <class Visit>
void SnapIndex::around(const Vector2d& at, double reach_m, Visit visit) const {
  if (sides_.empty() || !(reach_m > 0)) return;
  const std::int32_t left = columnOf(at.x() - reach_m), right = columnOf(at.x() + reach_m);
  const std::int32_t low = columnOf(at.y() - reach_m), high = columnOf(at.y() + reach_m);
  if (right - left > kMostAround || high - low > kMostAround) {
    // Far zoomed out all of them are near.
    for (const Side& side : sides_) visit(side);
    return;
  }
  for (std::int32_t row = low; row <= high; ++row) {
    for (std::int32_t column = left; column <= right; ++column) {
      const auto found = by_cell_.find(cellOf(column, row));
      if (found == by_cell_.end()) continue;
      for (const std::uint32_t i : found->second) visit(sides_[i]);
    }
  }
}

std::optional<Vector2d> SnapIndex::nearestVertex(const Vector2d& at, double reach_m,
                                                 const Ignored& ignored) const {
  std::optional<Vector2d> nearest;
  double best = reach_m * reach_m;
  around(at, reach_m, [&](const Side& side) {
    for (const Vector2d& end : {side.from_m, side.to_m}) {
      const double distance = (end - at).squaredNorm();
      if (distance > best || (ignored && ignored(side.key))) continue;
      best = distance;
      nearest = end;
    }
  });
  return nearest;
}

std::optional<SnapIndex::Side> SnapIndex::nearestSide(const Vector2d& at, double reach_m,
                                                      const Ignored& ignored) const {
  std::optional<Side> nearest;
  double best = reach_m * reach_m;
  around(at, reach_m, [&](const Side& side) {
    if (side.from_m == side.to_m) return;
    const double distance = (nearestOn(side, at) - at).squaredNorm();
    if (distance > best || (ignored && ignored(side.key))) return;
    best = distance;
    nearest = side;
  });
  return nearest;
}

Snapped snapped(const Vector2d& free_m, double reach_m, const SnapKinds& kinds, const SnapScene& scene) {
  Snapped result{free_m};
  if (kinds.vertices && scene.index) {
    if (const auto vertex = scene.index->nearestVertex(free_m, reach_m, scene.ignored))
      return {*vertex, SnapTo::Vertex};
  }
  if (kinds.edges && scene.index) {
    if (const auto side = scene.index->nearestSide(free_m, reach_m, scene.ignored))
      return {nearestOn(*side, free_m), SnapTo::Edge, side->from_m, side->to_m};
  }
  if (kinds.walls && scene.ground) {
    const auto wall = scene.ground->nearestWall(free_m, reach_m);
    if (wall && wall->distance_m > 0) return {wall->at_m, SnapTo::Wall};
  }
  if (kinds.angles) {
    const double step = scene.angle_step_deg * std::numbers::pi / 180;
    double best = reach_m;
    for (const Vector2d& from : scene.arms_m) {
      const Vector2d arm = free_m - from;
      const double angle = std::round(std::atan2(arm.y(), arm.x()) / step) * step;
      const Vector2d along(std::cos(angle), std::sin(angle));
      double length = arm.dot(along);
      const double away = (from + along * length - free_m).norm();
      if (arm.norm() <= reach_m || away > best) continue;
      best = away;
      // Along it the grid still counts, as a length.
      const double whole = kinds.grid ? std::round(length / kinds.grid_m) * kinds.grid_m : length;
      if (std::abs(whole - length) <= reach_m) length = whole;
      result = {from + along * length, SnapTo::Angle, from, from + along * length};
    }
    if (result.to != SnapTo::Nothing) return result;
  }
  if (kinds.grid && kinds.grid_m > 0) {
    for (const int axis : {0, 1}) {
      const double line = std::round(free_m[axis] / kinds.grid_m) * kinds.grid_m;
      if (std::abs(line - free_m[axis]) > reach_m) continue;
      result.at_m[axis] = line;
      result.to = SnapTo::Grid;
    }
  }
  return result;
}

}  // namespace mapwright::overlays
