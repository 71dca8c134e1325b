// A map reduced to what aligning needs: what is wall, what is free, what nobody saw. Pure values.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "geometry/rect.h"

namespace mapwright::align {

enum class Ground : std::uint8_t { Unknown, Free, Wall };

/// Cells along the axes of the map's own world: the first is at the lower left, x runs along the rows, y
/// across them.
struct Plan {
  int width = 0, height = 0;
  double resolution_m = 0;
  Eigen::Vector2d corner_m{0, 0};  // the outer corner of the first cell
  std::vector<Ground> cells;       // width * height
  bool operator==(const Plan&) const = default;

  Ground at(int column, int row) const {
    return cells[std::size_t(row) * std::size_t(width) + std::size_t(column)];
  }
  Eigen::Vector2d centreOf(int column, int row) const {
    return corner_m + resolution_m * Eigen::Vector2d(column + 0.5, row + 0.5);
  }
};

/// The smallest part of it that holds all known cells; 0 x 0 without any.
Plan trimmed(const Plan& plan);
/// Walls farther than `reach_m` from all free ground count as unknown: nobody saw them, a picture was filled
/// there. Nothing changes in a map without free ground.
Plan seenOnly(Plan plan, double reach_m);
/// With cells `times` as large: wall where one of them is wall, else free where one is free.
Plan coarser(const Plan& plan, int times);

}  // namespace mapwright::align
