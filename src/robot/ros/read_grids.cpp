// Grids of occupancy and their patches.
#include <algorithm>
#include <cmath>
#include <limits>

#include "robot/ros/parts.h"

namespace mapwright::robot::ros {
namespace {

constexpr std::int64_t kMostCells = std::int64_t(1) << 28;  // a frame of rosbridge holds no more
/// Cells that are no bytes take eight times the memory while they are read.
constexpr std::size_t kMostOddCells = std::size_t(1) << 25;
constexpr std::int8_t kUnknown = -1, kOccupied = 100;

struct Cells {
  std::vector<std::int8_t> cells;
  std::size_t odd = 0;
};

Read<Cells> readCells(const Field& data, std::int64_t width, std::int64_t height) {
  const std::size_t needed = std::size_t(width * height);
  if (!data.isList()) return fieldMissing("data");
  // Some of a list of the wrong length would be cells of other places.
  if (data.size() != needed) {
    return tl::unexpected(map::Reason(map::ReasonCode::RosLengthDiffers,
                                      {"data", std::int64_t(data.size()), std::int64_t(needed)}));
  }
  Cells read;
  if (auto bytes = data.int8s(needed)) {
    read.cells = std::move(*bytes);
    for (std::int8_t& cell : read.cells) {
      if (cell >= kUnknown && cell <= kOccupied) continue;
      cell = kUnknown;
      ++read.odd;
    }
    return read;
  }
  const auto numbers = data.numbers(kMostOddCells);
  if (!numbers || numbers->size() != needed) return fieldMissing("data");
  read.cells.reserve(needed);
  for (const double value : *numbers) {
    const bool whole = value >= kUnknown && value <= kOccupied && value == std::floor(value);
    read.cells.push_back(whole ? std::int8_t(value) : kUnknown);
    read.odd += !whole;
  }
  return read;
}

/// Width and height, at least 1.
struct Size {
  std::int64_t width = 0, height = 0;
};
Read<Size> readSize(const Field& of, const std::string& prefix) {
  const auto width = of["width"].integer(), height = of["height"].integer();
  if (!width) return fieldMissing(prefix + "width");
  if (!height) return fieldMissing(prefix + "height");
  if (*width < 0 || *width > kMostCells) return fieldWrong(prefix + "width", double(*width));
  if (*height < 0 || *height > kMostCells) return fieldWrong(prefix + "height", double(*height));
  if (*width == 0 || *height == 0)
    return tl::unexpected(map::Reason(map::ReasonCode::RosGridEmpty, {*width, *height}));
  if (*height > kMostCells / *width) return fieldWrong(prefix + "height", double(*height));
  return Size{*width, *height};
}

void noteOdd(std::vector<map::Reason>& notes, std::size_t odd) {
  if (odd > 0) notes.push_back({map::ReasonCode::RosCellsOutOfRange, {std::int64_t(odd)}});
}

}  // namespace

Read<Grid> readGrid(const Field& msg) {
  const Field info = msg["info"];
  if (!info.isObject()) return fieldMissing("info");
  const auto size = readSize(info, "info.");
  if (!size) return tl::unexpected(size.error());
  const PoseRead origin = poseOf(info["origin"]);
  Grid grid;
  grid.header = headerOf(msg);
  grid.width = int(size->width);
  grid.height = int(size->height);
  grid.resolution_m = numberOr(info["resolution"], std::numeric_limits<double>::quiet_NaN());
  grid.origin = origin.pose.flat();
  if (origin.upright) grid.notes.push_back(map::ReasonCode::RosTurnIsZero);
  if (const auto why = map::whyUnusable({grid.width, grid.height, grid.resolution_m, grid.origin}))
    return tl::unexpected(*why);
  auto cells = readCells(msg["data"], size->width, size->height);
  if (!cells) return tl::unexpected(cells.error());
  grid.cells = std::move(cells->cells);
  noteOdd(grid.notes, cells->odd);
  return grid;
}

Read<GridPatch> readGridPatch(const Field& msg) {
  constexpr auto kFits = [](std::int64_t value) { return std::abs(value) <= kMostCells; };
  const auto x = msg["x"].integer(), y = msg["y"].integer();
  if (!x) return fieldMissing("x");
  if (!y) return fieldMissing("y");
  if (!kFits(*x)) return fieldWrong("x", double(*x));
  if (!kFits(*y)) return fieldWrong("y", double(*y));
  const auto size = readSize(msg, {});
  if (!size) return tl::unexpected(size.error());
  auto cells = readCells(msg["data"], size->width, size->height);
  if (!cells) return tl::unexpected(cells.error());
  GridPatch patch;
  patch.header = headerOf(msg);
  patch.x = int(*x);
  patch.y = int(*y);
  patch.width = int(size->width);
  patch.height = int(size->height);
  patch.cells = std::move(cells->cells);
  noteOdd(patch.notes, cells->odd);
  return patch;
}

std::optional<map::Reason> applyPatch(Grid& grid, const GridPatch& patch) {
  const bool lies_in = patch.x >= 0 && patch.y >= 0 && patch.width > 0 && patch.height > 0 &&
                       patch.width <= grid.width - patch.x && patch.height <= grid.height - patch.y;
  const bool whole = patch.cells.size() == std::size_t(std::int64_t(patch.width) * patch.height) &&
                     grid.cells.size() == std::size_t(std::int64_t(grid.width) * grid.height);
  if (!lies_in || !whole) {
    return map::Reason(map::ReasonCode::RosPatchOutside,
                       {patch.width, patch.height, patch.x, patch.y, grid.width, grid.height});
  }
  for (int row = 0; row < patch.height; ++row) {
    std::copy_n(patch.cells.begin() + std::ptrdiff_t(row) * patch.width, patch.width,
                grid.cells.begin() + std::ptrdiff_t(patch.y + row) * grid.width + patch.x);
  }
  return std::nullopt;
}

}  // namespace mapwright::robot::ros
