#include "render/texture_index.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace mapwright::render {
namespace {

// Far beyond any map, and exactly representable either way.
constexpr double kFarthestCell = 1e15;

std::int64_t cellCoordinate(double metres, double cell_m) {
  return std::int64_t(std::clamp(std::floor(metres / cell_m), -kFarthestCell, kFarthestCell));
}

/// The extent of a cell along one axis. The outermost also contain everything beyond.
std::pair<double, double> reachOf(std::int64_t coordinate, int height, double cell_m) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::int64_t last = std::int64_t(kFarthestCell) >> (TextureIndex::kFanBits * height);
  const std::int64_t first = -std::int64_t(kFarthestCell) >> (TextureIndex::kFanBits * height);
  return {coordinate <= first ? -kInfinity : double(coordinate) * cell_m,
          coordinate >= last ? kInfinity : double(coordinate + 1) * cell_m};
}

bool finer(const std::pair<double, std::size_t>& count, double resolution_m) {
  return count.first < resolution_m;
}

bool sameTexture(const PlacedTexture& a, const PlacedTexture& b) {
  return a.texture == b.texture && a.world_from_texture == b.world_from_texture && a.flags == b.flags;
}

// Numbers with room for arithmetic: sums and differences stay finite.
bool sane(double metres) { return std::abs(metres) < 1e300; }

bool drawable(const PlacedTexture& placed, const geometry::WorldRect& bounds) {
  return placed.texture != nullptr && sane(placed.world_from_texture.yaw_rad) && sane(bounds.min_x) &&
         sane(bounds.min_y) && sane(bounds.max_x) && sane(bounds.max_y);
}

}  // namespace

std::size_t TextureIndex::CellHash::operator()(const Cell& cell) const noexcept {
  std::uint64_t h = std::uint64_t(cell.x) * 0x9e3779b97f4a7c15ULL;
  h = (h ^ (h >> 29) ^ std::uint64_t(cell.y)) * 0xbf58476d1ce4e5b9ULL;
  h = (h ^ (h >> 32) ^ std::uint64_t(cell.size_class * 64 + cell.height)) * 0x94d049bb133111ebULL;
  return std::size_t(h ^ (h >> 31));
}

TextureIndex::Cell TextureIndex::parentOf(const Cell& cell) {
  // Shifting rounds down for negative coordinates, too.
  return {cell.size_class, cell.height + 1, cell.x >> kFanBits, cell.y >> kFanBits};
}

int TextureIndex::partOf(const Cell& cell) {
  return int(cell.x & (kFan - 1)) + kFan * int(cell.y & (kFan - 1));
}

TextureIndex::Cell TextureIndex::cellOf(const geometry::WorldRect& bounds) {
  const double side = std::max({bounds.width(), bounds.height(), 1e-6});
  const int size_class = std::ilogb(side) + 1;
  const double cell_m = std::ldexp(1.0, size_class);
  const Eigen::Vector2d center = bounds.center();
  return {size_class, 0, cellCoordinate(center.x(), cell_m), cellCoordinate(center.y(), cell_m)};
}

void TextureIndex::file(const Entry& entry) {
  const double resolution_m = entry.placed.texture->resolutionM();
  ++resolutions_[resolution_m];
  Cell cell = cellOf(entry.bounds);
  std::uint64_t part = 0;
  for (; cell.height <= kDepth; cell = parentOf(cell)) {
    Node& node = cells_[cell];
    if (cell.height == 0) node.entries.push_back(&entry);
    node.parts |= part;
    auto count = std::lower_bound(node.resolutions.begin(), node.resolutions.end(), resolution_m, finer);
    if (count == node.resolutions.end() || count->first != resolution_m)
      count = node.resolutions.insert(count, {resolution_m, 0});
    ++count->second;
    part = std::uint64_t(1) << partOf(cell);
    if (cell.height < kDepth) continue;
    Class& of = classes_[cell.size_class];
    ++of.textures;
    ++of.tops[{cell.x, cell.y}];
  }
}

void TextureIndex::unfile(const Entry& entry) {
  const double resolution_m = entry.placed.texture->resolutionM();
  const auto resolution = resolutions_.find(resolution_m);
  if (--resolution->second == 0) resolutions_.erase(resolution);
  Cell cell = cellOf(entry.bounds);
  std::uint64_t gone = 0;
  for (; cell.height <= kDepth; cell = parentOf(cell)) {
    const auto found = cells_.find(cell);
    Node& node = found->second;
    if (cell.height == 0) std::erase(node.entries, &entry);
    node.parts &= ~gone;
    const auto count =
        std::lower_bound(node.resolutions.begin(), node.resolutions.end(), resolution_m, finer);
    if (--count->second == 0) node.resolutions.erase(count);
    gone = node.resolutions.empty() ? std::uint64_t(1) << partOf(cell) : 0;
    if (gone != 0) cells_.erase(found);
    if (cell.height < kDepth) continue;
    const auto of = classes_.find(cell.size_class);
    const auto top = of->second.tops.find({cell.x, cell.y});
    if (--top->second == 0) of->second.tops.erase(top);
    if (--of->second.textures == 0) classes_.erase(of);
  }
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
  classes_.clear();
  resolutions_.clear();
}

geometry::WorldRect TextureIndex::bounds() const {
  geometry::WorldRect rect;
  for (const auto& [id, entry] : entries_) rect.extend(entry.bounds);
  return rect;
}

template <typename Enter, typename Visit>
bool TextureIndex::walk(const Cell& cell, const geometry::WorldRect& rect, Enter& enter, Visit& visit) const {
  const Node& node = cells_.find(cell)->second;
  // The range of the centres filed below. It extends at most half a leaf beyond.
  const double leaf_m = std::ldexp(1.0, cell.size_class);
  const double cell_m = std::ldexp(leaf_m, kFanBits * cell.height);
  const auto [min_x, max_x] = reachOf(cell.x, cell.height, cell_m);
  const auto [min_y, max_y] = reachOf(cell.y, cell.height, cell_m);
  const geometry::WorldRect centres{min_x, min_y, max_x, max_y};
  if (!centres.grown(leaf_m / 2).intersects(rect)) return true;
  const bool inside = centres.min_x >= rect.min_x && centres.max_x <= rect.max_x &&
                      centres.min_y >= rect.min_y && centres.max_y <= rect.max_y;
  if (!enter(node, inside)) return true;
  for (const Entry* entry : node.entries) {
    if (entry->bounds.intersects(rect) && !visit(*entry)) return false;
  }
  for (std::uint64_t left = node.parts; left != 0; left &= left - 1) {
    const int part = std::countr_zero(left);
    const Cell below{cell.size_class, cell.height - 1, cell.x * kFan + part % kFan,
                     cell.y * kFan + part / kFan};
    if (!walk(below, rect, enter, visit)) return false;
  }
  return true;
}

template <typename Enter, typename Visit>
void TextureIndex::walkWithin(const geometry::WorldRect& rect, Enter enter, Visit visit) const {
  if (rect.empty()) return;
  for (const auto& [size_class, of] : classes_) {
    for (const auto& [top, textures] : of.tops) {
      if (!walk({size_class, kDepth, top.first, top.second}, rect, enter, visit)) return;
    }
  }
}

std::vector<PlacedTexture> TextureIndex::within(const geometry::WorldRect& rect) const {
  std::vector<PlacedTexture> found;
  walkWithin(
      rect, [](const Node&, bool) { return true; },
      [&](const Entry& entry) {
        found.push_back(entry.placed);
        return true;
      });
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  return found;
}

bool TextureIndex::anyWithin(const geometry::WorldRect& rect) const {
  bool any = false;
  walkWithin(
      rect,
      [&](const Node&, bool inside) {
        any |= inside;
        return !any;
      },
      [&](const Entry&) {
        any = true;
        return false;
      });
  return any;
}

std::optional<double> TextureIndex::finestWithin(const geometry::WorldRect& rect) const {
  std::optional<double> finest_m;
  const auto take = [&](double resolution_m) {
    finest_m = finest_m ? std::min(*finest_m, resolution_m) : resolution_m;
  };
  walkWithin(
      rect,
      [&](const Node& node, bool inside) {
        if (inside) take(node.resolutions.front().first);
        return !inside && (!finest_m || node.resolutions.front().first < *finest_m);
      },
      [&](const Entry& entry) {
        take(entry.placed.texture->resolutionM());
        return true;
      });
  return finest_m;
}

std::optional<double> TextureIndex::finest() const {
  if (resolutions_.empty()) return std::nullopt;
  return resolutions_.begin()->first;
}

}  // namespace mapwright::render
