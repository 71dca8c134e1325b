// One rectangle of the received cells, as a grid: nothing is copied or reduced before it is used, so cutting
// out is instant.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <mutex>
#include <tuple>
#include <utility>

#include "grids/grid_pyramid.h"
#include "grids/reduce_grid.h"
#include "regions/region_fetch.h"
#include "regions/region_sheet.h"

namespace mapwright::regions {
namespace {

struct CellBox {
  int left = 0, top = 0, right = -1, bottom = -1;  // inclusive
  int width() const { return right - left + 1; }
  int height() const { return bottom - top + 1; }
  bool empty() const { return width() <= 0 || height() <= 0; }
};

/// The cells of a sheet that may belong to `rect`.
CellBox boxOf(const RegionSheet& sheet, const geometry::WorldRect& rect, CutEdge edge) {
  geometry::WorldRect box;
  for (const double x : {rect.min_x, rect.max_x}) {
    for (const double y : {rect.min_y, rect.max_y}) box.extend(sheet.reference().cellFromWorld({x, y}));
  }
  constexpr double kRounding = 1e-6;
  const bool middles = edge == CutEdge::Middles;
  const auto first = [middles](double at) {
    return std::max(0.0, middles ? std::ceil(at - 0.5 - kRounding) : std::floor(at + kRounding));
  };
  const auto last = [middles](double at, int size) {
    return std::min(size - 1.0, std::ceil(at - (middles ? 0.5 : 0) - kRounding) - 1);
  };
  const double left = first(box.min_x), top = first(box.min_y), right = last(box.max_x, sheet.width()),
               bottom = last(box.max_y, sheet.height());
  if (!(left <= right && top <= bottom)) return {};
  return {int(left), int(top), int(right), int(bottom)};
}

std::int64_t tilesIn(const RegionSheet& sheet, const CellBox& box) {
  std::int64_t count = 0;
  for (int y = box.top / kTile; !box.empty() && y <= box.bottom / kTile; ++y) {
    for (int x = box.left / kTile; x <= box.right / kTile; ++x) count += sheet.tile(0, x, y).has_value();
  }
  return count;
}

/// The cells of `box`, from a sheet in its present state. In a rotated one, cells whose centres are outside
/// `rect` are unknown if they do not belong to it.
class CutGrid final : public grids::GridPyramid {
 public:
  CutGrid(const RegionSheet& sheet, const CellBox& box, const geometry::WorldRect& rect, CutEdge edge)
      : box_(box),
        rect_(rect),
        of_sheet_(sheet.reference()),
        trimmed_(of_sheet_.origin.yaw_rad != 0 && edge == CutEdge::Middles) {
    for (int y = box.top / kTile; y <= box.bottom / kTile; ++y) {
      for (int x = box.left / kTile; x <= box.right / kTile; ++x) {
        const auto tile = sheet.tile(0, x, y);
        from_.push_back(tile ? tile->cells : nullptr);
        held_ += tile.has_value();
      }
    }
    while (levelWidth(levels_ - 1) > kTile || levelHeight(levels_ - 1) > kTile) ++levels_;
  }

  int width() const override { return box_.width(); }
  int height() const override { return box_.height(); }
  int levels() const override { return levels_; }
  grids::CellCode code() const override { return grids::CellCode::Occupancy; }
  grids::Reduction reduction() const override { return grids::Reduction::OccupiedWins; }
  const std::array<std::uint8_t, 256>& order() const override { return reducer_.order(); }
  int rowsReady() const override { return height(); }
  std::size_t bytes() const override {
    const std::lock_guard lock(mutex_);
    return (held_ + made_.size()) * kSheetTileBytes;
  }
  std::optional<grids::GridTile> tile(int level, int tile_x, int tile_y) const override {
    if (level < 0 || level >= levels_ || tile_x < 0 || tile_y < 0 || tile_x * kTile >= levelWidth(level) ||
        tile_y * kTile >= levelHeight(level))
      return std::nullopt;
    return grids::GridTile{cellsOf(level, tile_x, tile_y), false, false};
  }

 private:
  using Cells = std::shared_ptr<const std::uint8_t>;

  static std::shared_ptr<std::uint8_t> unknown() {
    std::shared_ptr<std::uint8_t> cells(new std::uint8_t[kSheetTileBytes],
                                        std::default_delete<std::uint8_t[]>());
    std::memset(cells.get(), grids::kUnknownOccupancy, kSheetTileBytes);
    return cells;
  }

  Cells cellsOf(int level, int x, int y) const {
    {
      const std::lock_guard lock(mutex_);
      if (const auto found = made_.find({level, x, y}); found != made_.end()) return found->second;
    }
    Cells cells = level == 0 ? taken(x, y) : reduced(level, x, y);
    // Level 0 is quickly recomputed.
    if (level == 0) return cells;
    const std::lock_guard lock(mutex_);
    return made_.emplace(std::tuple(level, x, y), std::move(cells)).first->second;
  }

  /// A tile of level 0 overlaps up to four of the sheet.
  Cells taken(int x, int y) const {
    const auto cells = unknown();
    const int first_x = box_.left / kTile, first_y = box_.top / kTile,
              across = box_.right / kTile - first_x + 1;
    const int right = std::min(box_.right, box_.left + (x + 1) * kTile - 1),
              bottom = std::min(box_.bottom, box_.top + (y + 1) * kTile - 1);
    for (int v = box_.top + y * kTile; v <= bottom; ++v) {
      std::uint8_t* out = cells.get() + std::size_t(v - box_.top - y * kTile) * kTile;
      for (int u = box_.left + x * kTile; u <= right;) {
        const int end = std::min(right, (u / kTile + 1) * kTile - 1), count = end - u + 1;
        const Cells& from = from_[std::size_t((v / kTile - first_y) * across + u / kTile - first_x)];
        if (from) copyRow(from.get() + std::size_t(v % kTile) * kTile + u % kTile, out, count, u, v);
        out += count;
        u = end + 1;
      }
    }
    return cells;
  }
  void copyRow(const std::uint8_t* from, std::uint8_t* out, int count, int u, int v) const {
    for (int i = 0; i < count; ++i) out[i] = from[i] == kNotFetched ? grids::kUnknownOccupancy : from[i];
    for (int i = 0; trimmed_ && i < count; ++i) {
      if (!rect_.contains(of_sheet_.worldFromCell({u + i + 0.5, v + 0.5}))) out[i] = grids::kUnknownOccupancy;
    }
  }

  Cells reduced(int level, int x, int y) const {
    const auto cells = unknown();
    for (int down = 0; down < 2; ++down) {
      for (int across = 0; across < 2; ++across) {
        const int finer_x = 2 * x + across, finer_y = 2 * y + down;
        const int wide = std::min(kTile, levelWidth(level - 1) - finer_x * kTile),
                  high = std::min(kTile, levelHeight(level - 1) - finer_y * kTile);
        if (wide <= 0 || high <= 0) continue;
        const Cells finer = cellsOf(level - 1, finer_x, finer_y);
        for (int row = 0; row < (high + 1) / 2; ++row) {
          const std::uint8_t* const upper = finer.get() + std::size_t(row) * 2 * kTile;
          reducer_.reduceRow(upper, 2 * row + 1 < high ? upper + kTile : upper, std::size_t(wide),
                             cells.get() + std::size_t(row + down * kTile / 2) * kTile + across * kTile / 2);
        }
      }
    }
    return cells;
  }

  CellBox box_;
  geometry::WorldRect rect_;
  map::GridReference of_sheet_;
  bool trimmed_;
  grids::GridReducer reducer_{grids::CellCode::Occupancy, grids::Reduction::OccupiedWins};
  std::vector<Cells> from_;  // tiles of the sheet
  std::size_t held_ = 0;
  int levels_ = 1;
  mutable std::mutex mutex_;
  mutable std::map<std::tuple<int, int, int>, Cells> made_;  // of coarser levels
};

}  // namespace

FetchedGrid cutOut(const std::vector<std::shared_ptr<RegionSheet>>& sheets, const geometry::WorldRect& rect,
                   CutEdge edge) {
  FetchedGrid fetched;
  const RegionSheet* best = nullptr;
  std::int64_t most = 0;
  int with_cells = 0;
  for (const auto& sheet : sheets) {
    const std::int64_t tiles = tilesIn(*sheet, boxOf(*sheet, rect, edge));
    with_cells += tiles > 0;
    if (tiles > most) {
      most = tiles;
      best = sheet.get();
    }
  }
  if (!best) return fetched;
  fetched.other_lattices = with_cells - 1;
  const CellBox box = boxOf(*best, rect, edge);
  const map::GridReference& of_sheet = best->reference();
  const Eigen::Vector2d corner = of_sheet.worldFromCell({double(box.left), double(box.bottom + 1)});
  fetched.reference = {
      box.width(), box.height(), of_sheet.resolution_m, {corner.x(), corner.y(), of_sheet.origin.yaw_rad}};
  fetched.cells = std::make_shared<CutGrid>(*best, box, rect, edge);
  return fetched;
}

}  // namespace mapwright::regions
