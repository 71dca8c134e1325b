#include "render/texture_index.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

namespace mapwright::render {
namespace {

namespace spatial = boost::geometry::index;
using TreePoint = boost::geometry::model::point<double, 2, boost::geometry::cs::cartesian>;
using TreeBox = boost::geometry::model::box<TreePoint>;

TreeBox treeBox(const geometry::WorldRect& rect) {
  return {{rect.min_x, rect.min_y}, {rect.max_x, rect.max_y}};
}

bool sameTexture(const PlacedTexture& a, const PlacedTexture& b) {
  return a.texture == b.texture && a.world_from_texture == b.world_from_texture && a.flags == b.flags;
}

// Numbers with room for arithmetic.
bool sane(double metres) { return std::abs(metres) < 1e300; }

bool drawable(const PlacedTexture& placed, const geometry::WorldRect& bounds) {
  return placed.texture != nullptr && sane(placed.world_from_texture.yaw_rad) && sane(bounds.min_x) &&
         sane(bounds.min_y) && sane(bounds.max_x) && sane(bounds.max_y);
}

}  // namespace

struct TextureIndex::Tree {
  spatial::rtree<std::pair<TreeBox, const Entry*>, spatial::quadratic<16>> boxes;
  auto touching(const geometry::WorldRect& rect) const {
    return boxes.qbegin(spatial::intersects(treeBox(rect)));
  }
};

TextureIndex::TextureIndex() : tree_(std::make_unique<Tree>()) {}

TextureIndex::~TextureIndex() = default;

void TextureIndex::file(const Entry& entry) {
  ++resolutions_[entry.placed.texture->resolutionM()];
  tree_->boxes.insert({treeBox(entry.bounds), &entry});
}

void TextureIndex::unfile(const Entry& entry) {
  const auto resolution = resolutions_.find(entry.placed.texture->resolutionM());
  if (--resolution->second == 0) resolutions_.erase(resolution);
  tree_->boxes.remove({treeBox(entry.bounds), &entry});
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
  tree_->boxes.clear();
  entries_.clear();
  resolutions_.clear();
}

geometry::WorldRect TextureIndex::bounds() const {
  geometry::WorldRect rect;
  for (const auto& [id, entry] : entries_) rect.extend(entry.bounds);
  return rect;
}

std::vector<PlacedTexture> TextureIndex::within(const geometry::WorldRect& rect) const {
  std::vector<PlacedTexture> found;
  if (rect.empty()) return found;
  for (auto at = tree_->touching(rect); at != tree_->boxes.qend(); ++at) found.push_back(at->second->placed);
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  return found;
}

bool TextureIndex::anyWithin(const geometry::WorldRect& rect) const {
  return !rect.empty() && tree_->touching(rect) != tree_->boxes.qend();
}

std::optional<double> TextureIndex::finestWithin(const geometry::WorldRect& rect) const {
  std::optional<double> finest_m;
  if (rect.empty()) return finest_m;
  for (auto at = tree_->touching(rect); at != tree_->boxes.qend() && finest_m != finest(); ++at) {
    const double resolution_m = at->second->placed.texture->resolutionM();
    finest_m = std::min(finest_m.value_or(resolution_m), resolution_m);
  }
  return finest_m;
}

std::optional<double> TextureIndex::finest() const {
  if (resolutions_.empty()) return std::nullopt;
  return resolutions_.begin()->first;
}

}  // namespace mapwright::render
