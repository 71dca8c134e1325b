#include "render/texture_index.h"

#include <algorithm>
#include <cmath>

namespace mapwright::render {
namespace {

// Far beyond any map, and exactly representable either way.
constexpr double kFarthestCell = 1e15;

std::int64_t cellCoordinate(double metres, double cell_m) {
  return std::int64_t(std::clamp(std::floor(metres / cell_m), -kFarthestCell, kFarthestCell));
}

bool sameTexture(const PlacedTexture& a, const PlacedTexture& b) {
  return a.texture == b.texture && a.world_from_texture == b.world_from_texture && a.flags == b.flags;
}

// Numbers with room to reckon in: sums and differences of them stay finite.
bool sane(double metres) { return std::abs(metres) < 1e300; }

bool drawable(const PlacedTexture& placed, const geometry::WorldRect& bounds) {
  return placed.texture != nullptr && sane(placed.world_from_texture.yaw_rad) && sane(bounds.min_x) &&
         sane(bounds.min_y) && sane(bounds.max_x) && sane(bounds.max_y);
}

}  // namespace

std::size_t TextureIndex::CellHash::operator()(const Cell& cell) const noexcept {
  std::uint64_t h = std::uint64_t(cell.x) * 0x9e3779b97f4a7c15ULL;
  h = (h ^ (h >> 29) ^ std::uint64_t(cell.y)) * 0xbf58476d1ce4e5b9ULL;
  h = (h ^ (h >> 32) ^ std::uint64_t(cell.size_class)) * 0x94d049bb133111ebULL;
  return std::size_t(h ^ (h >> 31));
}

TextureIndex::Cell TextureIndex::cellOf(const geometry::WorldRect& bounds) {
  const double side = std::max({bounds.width(), bounds.height(), 1e-6});
  const int size_class = std::ilogb(side) + 1;
  const double cell_m = std::ldexp(1.0, size_class);
  const Eigen::Vector2d center = bounds.center();
  return {size_class, cellCoordinate(center.x(), cell_m), cellCoordinate(center.y(), cell_m)};
}

void TextureIndex::file(const Entry& entry) {
  const Cell cell = cellOf(entry.bounds);
  cells_[cell].push_back(&entry);
  ++class_counts_[cell.size_class];
  ++resolutions_[entry.placed.texture->resolutionM()];
}

void TextureIndex::unfile(const Entry& entry) {
  const Cell cell = cellOf(entry.bounds);
  const auto found = cells_.find(cell);
  std::erase(found->second, &entry);
  if (found->second.empty()) cells_.erase(found);
  const auto count = class_counts_.find(cell.size_class);
  if (--count->second == 0) class_counts_.erase(count);
  const auto resolution = resolutions_.find(entry.placed.texture->resolutionM());
  if (--resolution->second == 0) resolutions_.erase(resolution);
}

std::optional<TextureIndex::Change> TextureIndex::upsert(PlacedTexture placed) {
  const geometry::WorldRect bounds = boundsOf(placed);
  if (!drawable(placed, bounds)) {
    const auto before = remove(placed.id);
    if (!before) return std::nullopt;
    return Change{*before, {}};
  }
  const auto [entry, added] = entries_.try_emplace(placed.id);
  Change change{{}, bounds};
  if (!added) {
    if (sameTexture(entry->second.placed, placed)) return std::nullopt;
    change.before = entry->second.bounds;
    unfile(entry->second);
  }
  entry->second = {std::move(placed), bounds};
  file(entry->second);
  return change;
}

std::optional<geometry::WorldRect> TextureIndex::remove(map::SubmapId id) {
  const auto entry = entries_.find(id);
  if (entry == entries_.end()) return std::nullopt;
  const geometry::WorldRect bounds = entry->second.bounds;
  unfile(entry->second);
  entries_.erase(entry);
  return bounds;
}

void TextureIndex::clear() {
  entries_.clear();
  cells_.clear();
  class_counts_.clear();
  resolutions_.clear();
}

geometry::WorldRect TextureIndex::bounds() const {
  geometry::WorldRect rect;
  for (const auto& [id, entry] : entries_) rect.extend(entry.bounds);
  return rect;
}

template <typename Visit>
void TextureIndex::visitWithin(const geometry::WorldRect& rect, Visit visit) const {
  if (rect.empty()) return;
  for (const auto& [size_class, count] : class_counts_) {
    const double cell_m = std::ldexp(1.0, size_class);
    // What is filed in a cell reaches at most half a cell beyond it.
    const std::int64_t x0 = cellCoordinate(rect.min_x - cell_m / 2, cell_m);
    const std::int64_t x1 = cellCoordinate(rect.max_x + cell_m / 2, cell_m);
    const std::int64_t y0 = cellCoordinate(rect.min_y - cell_m / 2, cell_m);
    const std::int64_t y1 = cellCoordinate(rect.max_y + cell_m / 2, cell_m);
    const double wanted_cells = double(x1 - x0 + 1) * double(y1 - y0 + 1);
    if (wanted_cells > double(entries_.size())) {
      for (const auto& [id, entry] : entries_) {
        if (cellOf(entry.bounds).size_class == size_class && entry.bounds.intersects(rect) && !visit(entry))
          return;
      }
      continue;
    }
    for (std::int64_t y = y0; y <= y1; ++y) {
      for (std::int64_t x = x0; x <= x1; ++x) {
        const auto cell = cells_.find({size_class, x, y});
        if (cell == cells_.end()) continue;
        for (const Entry* entry : cell->second) {
          if (entry->bounds.intersects(rect) && !visit(*entry)) return;
        }
      }
    }
  }
}

std::vector<PlacedTexture> TextureIndex::within(const geometry::WorldRect& rect) const {
  std::vector<PlacedTexture> found;
  visitWithin(rect, [&](const Entry& entry) {
    found.push_back(entry.placed);
    return true;
  });
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  return found;
}

bool TextureIndex::anyWithin(const geometry::WorldRect& rect) const {
  bool any = false;
  visitWithin(rect, [&](const Entry&) {
    any = true;
    return false;
  });
  return any;
}

std::optional<double> TextureIndex::finestWithin(const geometry::WorldRect& rect) const {
  std::optional<double> finest_m;
  visitWithin(rect, [&](const Entry& entry) {
    const double resolution_m = entry.placed.texture->resolutionM();
    finest_m = finest_m ? std::min(*finest_m, resolution_m) : resolution_m;
    return true;
  });
  return finest_m;
}

std::optional<double> TextureIndex::finest() const {
  if (resolutions_.empty()) return std::nullopt;
  return resolutions_.begin()->first;
}

}  // namespace mapwright::render
