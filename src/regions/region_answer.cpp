#include "regions/region_answer.h"

#include <algorithm>
#include <cmath>

namespace mapwright::regions {
namespace {

constexpr double kRoundingCells = 2;  // the effect of edge cells or a margin on a rectangle

bool overlap(const geometry::WorldRect& a, const geometry::WorldRect& b, double touch) {
  return a.min_x < b.max_x - touch && b.min_x < a.max_x - touch && a.min_y < b.max_y - touch &&
         b.min_y < a.max_y - touch;
}

}  // namespace

bool liesElsewhere(const map::GridReference& answer, const geometry::WorldRect& asked) {
  // In the grid's axes: for a rotated grid, the surroundings of the region are a correct answer, too.
  const geometry::Pose2 to_grid = answer.origin.inverse();
  geometry::WorldRect around;
  for (const double x : {asked.min_x, asked.max_x}) {
    for (const double y : {asked.min_y, asked.max_y}) around.extend(to_grid.apply({x, y}));
  }
  const double wide = answer.width * answer.resolution_m, high = answer.height * answer.resolution_m;
  if (!overlap({0, 0, wide, high}, around, answer.resolution_m * 0.01)) return true;
  const double rounding = kRoundingCells * answer.resolution_m;
  const bool as_large =
      std::abs(wide - around.width()) <= rounding && std::abs(high - around.height()) <= rounding;
  const Eigen::Vector2d beside = Eigen::Vector2d(wide / 2, high / 2) - around.center();
  return as_large && beside.cwiseAbs().maxCoeff() > rounding;
}

std::optional<Eigen::Vector2d> aimAgainst(const map::GridReference& answer,
                                          const geometry::WorldRect& asked) {
  if (answer.origin.yaw_rad != 0) return std::nullopt;
  const geometry::WorldRect bounds = answer.bounds();
  const double rounding = kRoundingCells * answer.resolution_m;
  const Eigen::Vector2d size(asked.width(), asked.height());
  if (std::abs(bounds.width() - size.x()) > rounding || std::abs(bounds.height() - size.y()) > rounding)
    return std::nullopt;
  const Eigen::Vector2d beside = bounds.center() - asked.center();
  if (((beside.cwiseAbs() - size / 2).cwiseAbs().array() > rounding).any() || size.minCoeff() < 4 * rounding)
    return std::nullopt;
  return Eigen::Vector2d(beside.x() > 0 ? -0.5 : 0.5, beside.y() > 0 ? -0.5 : 0.5);
}

geometry::WorldRect commonGround(const map::GridReference& answer, const geometry::WorldRect& asked) {
  if (answer.origin.yaw_rad != 0) return {};
  const geometry::WorldRect bounds = answer.bounds();
  return {std::max(bounds.min_x, asked.min_x), std::max(bounds.min_y, asked.min_y),
          std::min(bounds.max_x, asked.max_x), std::min(bounds.max_y, asked.max_y)};
}

std::vector<geometry::WorldRect> without(const geometry::WorldRect& rect,
                                         const std::vector<geometry::WorldRect>& others) {
  std::vector<geometry::WorldRect> left{rect};
  for (const geometry::WorldRect& other : others) {
    std::vector<geometry::WorldRect> next;
    for (const geometry::WorldRect& piece : left) {
      if (!overlap(piece, other, 0)) {
        next.push_back(piece);
        continue;
      }
      const auto keep = [&](double min_x, double min_y, double max_x, double max_y) {
        if (min_x < max_x && min_y < max_y) next.push_back({min_x, min_y, max_x, max_y});
      };
      const double low = std::max(piece.min_y, other.min_y), high = std::min(piece.max_y, other.max_y);
      keep(piece.min_x, piece.min_y, piece.max_x, other.min_y);
      keep(piece.min_x, other.max_y, piece.max_x, piece.max_y);
      keep(piece.min_x, low, other.min_x, high);
      keep(other.max_x, low, piece.max_x, high);
    }
    left = std::move(next);
  }
  return left;
}

}  // namespace mapwright::regions
