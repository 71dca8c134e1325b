#include "regions/region_sheet.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace mapwright::regions {
namespace {

constexpr int kHalf = 195 * RegionSheet::kStep;  // 2 * kHalf is the most of a grid, in whole steps
static_assert(2 * kHalf <= grids::kMaxGridEdge && RegionSheet::kStep % kTile == 0);
constexpr double kReachM = 4e6;  // of half a sheet
// On the same lattice: smaller differences, in cells, are rounding. Resolutions come as float or double.
constexpr double kOffLattice = 0.05;
constexpr double kOtherResolution = 1e-6, kOtherTurn = 1e-6;

Eigen::Vector2d turned(const Eigen::Vector2d& p, double yaw_rad) {
  return geometry::Pose2{0, 0, yaw_rad}.apply(p);
}

std::shared_ptr<std::uint8_t> notFetched() {
  std::shared_ptr<std::uint8_t> cells(new std::uint8_t[kSheetTileBytes],
                                      std::default_delete<std::uint8_t[]>());
  std::memset(cells.get(), kNotFetched, kSheetTileBytes);
  return cells;
}

}  // namespace

RegionSheet::RegionSheet(const map::GridReference& piece)
    : reducer_(grids::CellCode::Occupancy, grids::Reduction::OccupiedWins) {
  const double resolution = piece.resolution_m, yaw = piece.origin.yaw_rad;
  const int half = std::max(1, int(std::min(double(kHalf), kReachM / resolution) / kStep)) * kStep;
  // Along the axes of the cells.
  const Eigen::Vector2d corner = turned({piece.origin.x_m, piece.origin.y_m}, -yaw);
  Eigen::Vector2d zero, lower_left;
  for (int axis = 0; axis < 2; ++axis) {
    const double cell = std::round(corner[axis] / resolution);
    zero[axis] = corner[axis] - cell * resolution;
    lower_left[axis] = zero[axis] + (std::floor(cell / kStep) * kStep - half) * resolution;
  }
  zero_ = turned(zero, yaw);
  const Eigen::Vector2d origin = turned(lower_left, yaw);
  reference_ = {2 * half, 2 * half, resolution, {origin.x(), origin.y(), yaw}};
  while (levelWidth(levels_ - 1) > kTile) ++levels_;
}

std::size_t RegionSheet::TileKeyHash::operator()(const TileKey& key) const noexcept {
  const std::uint64_t mixed =
      std::uint64_t(key.level) << 48 ^ std::uint64_t(unsigned(key.y)) << 24 ^ unsigned(key.x);
  return std::size_t(mixed * 0x9e3779b97f4a7c15u >> 16);
}

std::optional<grids::GridTile> RegionSheet::tile(int level, int tile_x, int tile_y) const {
  const Cells cells = made({level, tile_x, tile_y});
  if (!cells) return std::nullopt;
  return grids::GridTile{cells, false, false};
}

/// null: there is nothing.
RegionSheet::Cells RegionSheet::made(const TileKey& key) const {
  std::uint64_t changes = 0;
  {
    const std::lock_guard lock(mutex_);
    const auto found = tiles_.find(key);
    if (found == tiles_.end()) return nullptr;
    if (found->second) return found->second;
    changes = changes_;
  }
  Cells cells = reduced(key);
  const std::lock_guard lock(mutex_);
  const auto found = tiles_.find(key);
  if (changes == changes_ && found != tiles_.end()) found->second = cells;
  return cells;
}

std::size_t RegionSheet::bytes() const {
  const std::lock_guard lock(mutex_);
  return tiles_.size() * kSheetTileBytes;
}

bool RegionSheet::empty() const { return tiles_.empty(); }

geometry::WorldRect RegionSheet::bounds() const {
  geometry::WorldRect rect;
  for (const auto& [key, cells] : tiles_) {
    if (key.level != 0) continue;
    for (const int x : {key.x, key.x + 1}) {
      for (const int y : {key.y, key.y + 1})
        rect.extend(reference_.worldFromCell({double(x) * kTile, double(y) * kTile}));
    }
  }
  return rect;
}

Eigen::Vector2d RegionSheet::cornerOf(const map::GridReference& piece) const {
  return reference_.origin.inverse().apply({piece.origin.x_m, piece.origin.y_m}) / reference_.resolution_m;
}

bool RegionSheet::holds(const map::GridReference& piece) const {
  if (std::abs(piece.resolution_m / reference_.resolution_m - 1) > kOtherResolution) return false;
  if (std::abs(geometry::normalizeAngle(piece.origin.yaw_rad - reference_.origin.yaw_rad)) > kOtherTurn)
    return false;
  const Eigen::Vector2d corner = cornerOf(piece);
  for (int axis = 0; axis < 2; ++axis) {
    const double cell = std::round(corner[axis]);
    if (!(std::abs(corner[axis] - cell) <= kOffLattice) || cell < 0) return false;
  }
  return std::round(corner.x()) + piece.width <= reference_.width &&
         std::round(corner.y()) + piece.height <= reference_.height;
}

std::shared_ptr<std::uint8_t> RegionSheet::copyOf(const TileKey& key) const {
  const auto found = tiles_.find(key);
  if (found == tiles_.end()) return notFetched();
  std::shared_ptr<std::uint8_t> cells(new std::uint8_t[kSheetTileBytes],
                                      std::default_delete<std::uint8_t[]>());
  std::memcpy(cells.get(), found->second.get(), kSheetTileBytes);
  return cells;
}

void RegionSheet::put(const map::GridReference& piece, const std::vector<std::int8_t>& cells) {
  const Eigen::Vector2d corner = cornerOf(piece);
  const int left = int(std::lround(corner.x()));
  const int bottom = reference_.height - 1 - int(std::lround(corner.y()));  // from the top, of its row 0
  const int top = bottom - piece.height + 1, right = left + piece.width - 1;
  std::vector<std::pair<TileKey, Cells>> changed;
  for (int y = top / kTile; y <= bottom / kTile; ++y) {
    for (int x = left / kTile; x <= right / kTile; ++x) {
      const TileKey key{0, x, y};
      const auto tile = copyOf(key);
      const int from = std::max(left, x * kTile), to = std::min(right, x * kTile + kTile - 1);
      for (int row = std::max(top, y * kTile); row <= std::min(bottom, y * kTile + kTile - 1); ++row) {
        const std::int8_t* const source =
            cells.data() + std::size_t(bottom - row) * std::size_t(piece.width) + std::size_t(from - left);
        std::uint8_t* const target = tile.get() + std::size_t(row - y * kTile) * kTile + (from - x * kTile);
        for (int at = 0; at <= to - from; ++at) {
          const auto byte = std::uint8_t(source[at]);
          target[at] = byte == kNotFetched ? grids::kUnknownOccupancy : byte;
        }
      }
      changed.emplace_back(key, tile);
    }
  }
  replaceTiles(std::move(changed));
}

std::optional<RegionSheet::CellBox> RegionSheet::boxAround(const geometry::WorldRect& rect) const {
  if (rect.empty()) return std::nullopt;
  geometry::WorldRect box;
  for (const double x : {rect.min_x, rect.max_x}) {
    for (const double y : {rect.min_y, rect.max_y}) box.extend(reference_.cellFromWorld({x, y}));
  }
  if (!(box.max_x >= 0 && box.max_y >= 0 && box.min_x < width() && box.min_y < height())) return std::nullopt;
  return CellBox{int(std::floor(std::max(box.min_x, 0.0))), int(std::floor(std::max(box.min_y, 0.0))),
                 int(std::min(std::floor(box.max_x), width() - 1.0)),
                 int(std::min(std::floor(box.max_y), height() - 1.0))};
}

template <typename Inside>
bool RegionSheet::forgetWhere(const CellBox& box, Inside inside) {
  std::vector<std::pair<TileKey, Cells>> changed;
  for (const auto& [key, old] : tiles_) {
    const int left = key.x * kTile, top = key.y * kTile;
    if (key.level != 0 || left > box.right || top > box.bottom || left + kTile <= box.left ||
        top + kTile <= box.top)
      continue;
    std::shared_ptr<std::uint8_t> tile;
    for (int v = std::max(top, box.top); v <= std::min(top + kTile - 1, box.bottom); ++v) {
      for (int u = std::max(left, box.left); u <= std::min(left + kTile - 1, box.right); ++u) {
        const std::size_t at = std::size_t(v - top) * kTile + std::size_t(u - left);
        if (old.get()[at] == kNotFetched || !inside(reference_.worldFromCell({u + 0.5, v + 0.5}))) continue;
        if (!tile) tile = copyOf(key);
        tile.get()[at] = kNotFetched;
      }
    }
    if (!tile) continue;
    const bool nothing = std::all_of(tile.get(), tile.get() + kSheetTileBytes,
                                     [](std::uint8_t cell) { return cell == kNotFetched; });
    changed.emplace_back(key, nothing ? nullptr : Cells(tile));
  }
  if (changed.empty()) return false;
  replaceTiles(std::move(changed));
  return true;
}

bool RegionSheet::holdsAnyOf(const geometry::WorldRect& rect) const {
  const auto box = boxAround(rect);
  if (!box) return false;
  for (const auto& [key, cells] : tiles_) {
    if (key.level != 0) continue;
    const int left = key.x * kTile, top = key.y * kTile;
    for (int v = std::max(top, box->top); v <= std::min(top + kTile - 1, box->bottom); ++v) {
      for (int u = std::max(left, box->left); u <= std::min(left + kTile - 1, box->right); ++u) {
        const std::size_t at = std::size_t(v - top) * kTile + std::size_t(u - left);
        if (cells.get()[at] != kNotFetched && rect.contains(reference_.worldFromCell({u + 0.5, v + 0.5})))
          return true;
      }
    }
  }
  return false;
}

bool RegionSheet::forget(const geometry::WorldRect& rect) {
  const auto box = boxAround(rect);
  return box && forgetWhere(*box, [&](const Eigen::Vector2d& middle) { return rect.contains(middle); });
}

bool RegionSheet::forgetUnder(const map::GridReference& piece) {
  const auto box = boxAround(piece.bounds());
  if (!box) return false;
  const geometry::Pose2 to_piece = piece.origin.inverse();
  const double wide = piece.width * piece.resolution_m, high = piece.height * piece.resolution_m;
  return forgetWhere(*box, [&](const Eigen::Vector2d& middle) {
    const Eigen::Vector2d at = to_piece.apply(middle);
    return at.x() >= 0 && at.y() >= 0 && at.x() < wide && at.y() < high;
  });
}

RegionSheet::Cells RegionSheet::reduced(const TileKey& key) const {
  const std::shared_ptr<std::uint8_t> cells = notFetched();
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 2; ++x) {
      const Cells from = made({key.level - 1, key.x * 2 + x, key.y * 2 + y});
      if (!from) continue;
      for (int row = 0; row < kTile / 2; ++row) {
        reducer_.reduceRow(from.get() + std::size_t(row) * 2 * kTile,
                           from.get() + (std::size_t(row) * 2 + 1) * kTile, kTile,
                           cells.get() + std::size_t(row + y * kTile / 2) * kTile + x * kTile / 2);
      }
    }
  }
  return cells;
}

void RegionSheet::replaceTiles(std::vector<std::pair<TileKey, Cells>> changed) {
  const std::lock_guard lock(mutex_);
  ++changes_;
  std::vector<TileKey> finer;
  for (auto& [key, cells] : changed) {
    finer.push_back(key);
    if (cells) {
      tiles_[key] = std::move(cells);
    } else {
      tiles_.erase(key);
    }
  }
  for (int level = 1; level < levels_; ++level) {
    std::vector<TileKey> coarser;
    for (const TileKey& key : finer) {
      const TileKey above{level, key.x / 2, key.y / 2};
      if (std::find(coarser.begin(), coarser.end(), above) != coarser.end()) continue;
      coarser.push_back(above);
      bool any = false;
      for (const int x : {0, 1}) {
        for (const int y : {0, 1})
          any = any || tiles_.contains({level - 1, above.x * 2 + x, above.y * 2 + y});
      }
      if (any) {
        tiles_[above] = nullptr;
      } else {
        tiles_.erase(above);
      }
    }
    finer = std::move(coarser);
  }
}

}  // namespace mapwright::regions
