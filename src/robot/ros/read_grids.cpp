// Grids of occupancy and their patches.
#include <algorithm>
#include <cmath>
#include <limits>

#include "robot/ros/faults.h"
#include "robot/ros/parts.h"
#include "robot/ros/read_cells.h"

namespace mapwright::robot::ros {
namespace {

constexpr std::int64_t kMostCells = std::int64_t(1) << 28;  // a rosbridge frame cannot hold more

}  // namespace

Read<Grid> readGrid(const Field& whole) {
  const Field msg = whole["info"].isObject() || !whole["map"].isObject() ? whole : whole["map"];
  const Field info = msg["info"];
  if (!info.isObject()) return fieldMissing("info");
  const auto size = readGridSize(info, "info.", kMostCells, EmptyGrids::Refused);
  if (!size) return tl::unexpected(size.error());
  const PoseRead origin = poseOf(info["origin"]);
  Grid grid;
  grid.header = headerOf(msg);
  grid.width = int(size->width);
  grid.height = int(size->height);
  grid.resolution_m = resolutionOf(info);
  grid.origin = origin.pose.flat();
  if (origin.upright) grid.notes.push_back(fault::RosTurnIsZero);
  if (const auto why = map::whyUnusable({grid.width, grid.height, grid.resolution_m, grid.origin}))
    return tl::unexpected(*why);
  auto cells = readCells(msg["data"], size->width, size->height, OddCells::Unknown);
  if (!cells) return tl::unexpected(cells.error());
  grid.cells = std::move(cells->cells);
  noteOddCells(grid.notes, cells->odd);
  return grid;
}

Read<GridPatch> readGridPatch(const Field& msg) {
  constexpr auto kFits = [](std::int64_t value) { return std::abs(value) <= kMostCells; };
  const auto x = msg["x"].integer(), y = msg["y"].integer();
  if (!x) return fieldMissing("x");
  if (!y) return fieldMissing("y");
  if (!kFits(*x)) return fieldWrong("x", double(*x));
  if (!kFits(*y)) return fieldWrong("y", double(*y));
  const auto size = readGridSize(msg, {}, kMostCells, EmptyGrids::Refused);
  if (!size) return tl::unexpected(size.error());
  auto cells = readCells(msg["data"], size->width, size->height, OddCells::Unknown);
  if (!cells) return tl::unexpected(cells.error());
  GridPatch patch;
  patch.header = headerOf(msg);
  patch.x = int(*x);
  patch.y = int(*y);
  patch.width = int(size->width);
  patch.height = int(size->height);
  patch.cells = std::move(cells->cells);
  noteOddCells(patch.notes, cells->odd);
  return patch;
}

std::optional<Fault> applyPatch(Grid& grid, const GridPatch& patch) {
  const bool lies_in = patch.x >= 0 && patch.y >= 0 && patch.width > 0 && patch.height > 0 &&
                       patch.width <= grid.width - patch.x && patch.height <= grid.height - patch.y;
  const bool whole = patch.cells.size() == std::size_t(std::int64_t(patch.width) * patch.height) &&
                     grid.cells.size() == std::size_t(std::int64_t(grid.width) * grid.height);
  if (!lies_in || !whole) {
    return Fault(fault::RosPatchOutside,
                 {patch.width, patch.height, patch.x, patch.y, grid.width, grid.height});
  }
  for (int row = 0; row < patch.height; ++row) {
    std::copy_n(patch.cells.begin() + std::ptrdiff_t(row) * patch.width, patch.width,
                grid.cells.begin() + std::ptrdiff_t(patch.y + row) * grid.width + patch.x);
  }
  return std::nullopt;
}

}  // namespace mapwright::robot::ros
