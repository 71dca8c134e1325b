#include "placing/ground.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "grids/grid_pyramid.h"

namespace mapwright::placing {
namespace {

constexpr int kEdge = grids::GridPyramid::kTileEdge;
constexpr std::size_t kHeldTiles = 64;  // one slot for each level and tile; the latest stays
constexpr int kMostCellsAcross = 4;     // of the level at which a search begins
constexpr double kMostCellsFine = 300;  // of a search that can only begin at level 0
constexpr double kNearCells =
    12;  // within this distance checking all cells is cheaper than unpacking a coarser level

/// The point of the square [column, column + side) x [row, row + side) that is nearest to `from`.
Eigen::Vector2d nearestIn(const Eigen::Vector2d& from, double column, double row, double side) {
  return {std::clamp(from.x(), column, column + side), std::clamp(from.y(), row, row + side)};
}

/// A coarser level shows whether anything below is occupied, as the fullest cell wins there.
bool coarseTells(const grids::GridPyramid& cells, const std::array<bool, 256>& occupied) {
  if (cells.reduction() != grids::Reduction::OccupiedWins) return false;
  const auto& order = cells.order();
  int least_occupied = 256, most_other = -1;
  for (std::size_t byte = 0; byte < 256; ++byte) {
    if (occupied[byte]) {
      least_occupied = std::min<int>(least_occupied, order[byte]);
    } else {
      most_other = std::max<int>(most_other, order[byte]);
    }
  }
  return least_occupied > most_other;
}

}  // namespace

Ground::Ground(PlacedMap map, Access access) : map_(std::move(map)), access_(access) {
  usable_ = map_.cells && !map::unusableReason(map_.reference) && map_.reference.width > 0 &&
            map_.reference.height > 0;
  if (!usable_) return;
  const grids::CellMeaning& meaning = grids::meaningOf(map_.cells->code());
  for (std::size_t byte = 0; byte < 256; ++byte) {
    known_[byte] = meaning.known[byte];
    occupied_[byte] = meaning.known[byte] && meaning.occupancy[byte] >= kOccupiedPercent;
  }
  unknown_ = grids::unknownByte(map_.cells->code());
  coarse_tells_ = coarseTells(*map_.cells, occupied_);
  held_.resize(kHeldTiles);
}

std::uint8_t Ground::byteAt(int level, int column, int row) {
  if (access_ == Access::AtHand) return map_.cells->at(column, row);  // level 0, always
  if (column < 0 || row < 0 || column >= map_.cells->levelWidth(level) ||
      row >= map_.cells->levelHeight(level))
    return unknown_;
  const std::uint8_t* const cells = tileAt(level, column / kEdge, row / kEdge);
  return cells ? cells[(row % kEdge) * kEdge + column % kEdge] : unknown_;
}

const std::uint8_t* Ground::tileAt(int level, int x, int y) {
  Held& held = held_[std::size_t((level % 4) * 16 + (y % 4) * 4 + x % 4)];
  if (held.level != level || held.x != x || held.y != y) {
    const auto tile = map_.cells->tile(level, x, y);
    held = {level, x, y, tile ? tile->cells : nullptr};
  }
  return held.cells.get();
}

Cell Ground::at(const Eigen::Vector2d& world_m) {
  if (!usable_ || !world_m.allFinite()) return Cell::Outside;
  const Eigen::Vector2d cell = map_.reference.cellFromWorld(world_m);
  if (!(cell.x() >= 0 && cell.y() >= 0 && cell.x() < map_.reference.width &&
        cell.y() < map_.reference.height))
    return Cell::Outside;
  const std::uint8_t byte = byteAt(0, int(cell.x()), int(cell.y()));
  return !known_[byte] ? Cell::Unknown : occupied_[byte] ? Cell::Occupied : Cell::Free;
}

void Ground::look(Search& search, int level, int column, int row) {
  const double side = double(1 << level);
  const Eigen::Vector2d nearest = nearestIn(search.from, column * side, row * side, side);
  const double distance = (nearest - search.from).norm();
  if (distance >= search.best || !occupied_[byteAt(level, column, row)]) return;
  if (level == 0) {
    search.best = distance;
    search.nearest = nearest;
    return;
  }
  // Visits the quarter with the position, or next to it, first: this prunes most others.
  const double half = side / 2;
  const int first_x = search.from.x() >= column * side + half ? 1 : 0,
            first_y = search.from.y() >= row * side + half ? 1 : 0;
  for (const auto& [x, y] : {std::pair(first_x, first_y), std::pair(1 - first_x, first_y),
                             std::pair(first_x, 1 - first_y), std::pair(1 - first_x, 1 - first_y)})
    look(search, level - 1, 2 * column + x, 2 * row + y);
}

void Ground::lookNear(Search& search) {
  const auto range = [reach = search.best](double at, int count) {
    return std::pair(int(std::clamp(std::floor(at - reach), 0.0, double(count))),
                     int(std::clamp(std::floor(at + reach) + 1, 0.0, double(count))));
  };
  const auto [left, right] = range(search.from.x(), map_.reference.width);
  const auto [top, bottom] = range(search.from.y(), map_.reference.height);
  for (int tile_y = top / kEdge; tile_y * kEdge < bottom; ++tile_y) {
    for (int tile_x = left / kEdge; tile_x * kEdge < right; ++tile_x) {
      const std::uint8_t* const cells = tileAt(0, tile_x, tile_y);
      if (!cells) continue;
      const int to_row = std::min(bottom, (tile_y + 1) * kEdge),
                to_column = std::min(right, (tile_x + 1) * kEdge);
      for (int row = std::max(top, tile_y * kEdge); row < to_row; ++row) {
        const std::uint8_t* const line = cells + (row % kEdge) * kEdge;
        for (int column = std::max(left, tile_x * kEdge); column < to_column; ++column) {
          if (!occupied_[line[column % kEdge]]) continue;
          const Eigen::Vector2d nearest = nearestIn(search.from, column, row, 1);
          const double distance = (nearest - search.from).norm();
          if (distance >= search.best) continue;
          search.best = distance;
          search.nearest = nearest;
        }
      }
    }
  }
}

void Ground::lookAround(Search& search) {
  // The level at which a handful of cells covers the reach.
  int level = 0;
  if (coarse_tells_ && access_ == Access::Wait) {
    while (level + 1 < map_.cells->levels() && search.best * 2 / double(1 << level) > kMostCellsAcross)
      ++level;
  }
  const double side = double(1 << level), reach = search.best;
  const auto range = [&](double at, int count) {
    const double last = count - 1;
    return std::pair(int(std::clamp(std::floor((at - reach) / side), 0.0, last)),
                     int(std::clamp(std::floor((at + reach) / side), 0.0, last)));
  };
  const auto [left, right] = range(search.from.x(), map_.cells->levelWidth(level));
  const auto [top, bottom] = range(search.from.y(), map_.cells->levelHeight(level));
  // Ring by ring around the position: ends when something is nearer than the next ring.
  const int x = std::clamp(int(std::floor(std::clamp(search.from.x() / side, -1e9, 1e9))), left, right),
            y = std::clamp(int(std::floor(std::clamp(search.from.y() / side, -1e9, 1e9))), top, bottom);
  const int rings = std::max({x - left, right - x, y - top, bottom - y});
  for (int ring = 0; ring <= rings && (ring - 1) * side < search.best; ++ring) {
    for (int row = std::max(top, y - ring); row <= std::min(bottom, y + ring); ++row) {
      const bool edge = row == y - ring || row == y + ring;
      const int step = edge || ring == 0 ? 1 : 2 * ring;
      for (int column = x - ring; column <= x + ring; column += step) {
        if (column >= left && column <= right) look(search, level, column, row);
      }
    }
  }
}

std::optional<Wall> Ground::nearestWall(const Eigen::Vector2d& world_m, double reach_m) {
  if (!usable_ || !world_m.allFinite() || !(reach_m > 0)) return std::nullopt;
  const double cell_m = map_.reference.resolution_m;
  double reach = std::min(reach_m / cell_m, 1e6);
  if (!coarse_tells_) reach = std::min(reach, kMostCellsFine);
  if (access_ == Access::AtHand) reach = std::min(reach, double(kMostCellsAtHand));
  Search search{map_.reference.cellFromWorld(world_m), reach, std::nullopt};
  reach <= kNearCells&& access_ == Access::Wait ? lookNear(search) : lookAround(search);
  if (!search.nearest) return std::nullopt;
  return Wall{search.best * cell_m, map_.reference.worldFromCell(*search.nearest)};
}

bool Ground::allUnknown() {
  if (!usable_) return true;
  const int level = map_.cells->levels() - 1;
  const auto tile = map_.cells->tile(level, 0, 0);
  if (!tile) return true;
  for (int row = 0; row < map_.cells->levelHeight(level); ++row) {
    for (int column = 0; column < map_.cells->levelWidth(level); ++column) {
      if (known_[tile->cells.get()[row * kEdge + column]]) return false;
    }
  }
  return true;
}

}  // namespace mapwright::placing
