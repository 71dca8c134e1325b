#include "render/pyramid.h"

#include <algorithm>
#include <cmath>

namespace mapwright::render {
namespace {

// No robot maps more finely; below this, tiles are composed instead of halved, so that a freak texture cannot
// demand endless levels.
constexpr double kFinestLevelM = 1e-3;
constexpr std::size_t kNodeBytes = 160;

double tileCoordinate(double tiles) { return std::clamp(std::floor(tiles), -9e15, 9e15); }

std::size_t bytesOf(const PyramidTilePtr& tile) { return kNodeBytes + (tile ? tile->bytes() : 0); }

}  // namespace

std::size_t Pyramid::KeyHash::operator()(const PyramidKey& key) const noexcept {
  std::uint64_t h = std::uint64_t(key.x) * 0x9e3779b97f4a7c15ULL + std::uint64_t(key.level);
  h = (h ^ (h >> 29) ^ std::uint64_t(key.y)) * 0xbf58476d1ce4e5b9ULL;
  return std::size_t(h ^ (h >> 32));
}

Pyramid::Pyramid(const TextureIndex& index, TileWorkers& workers, std::shared_ptr<DenseCache> dense)
    : index_(index), workers_(workers), dense_(std::move(dense)) {}

void Pyramid::setBase(double base_m_per_px) {
  if (base_m_per_px == base_m_per_px_) return;
  clear();
  base_m_per_px_ = base_m_per_px;
}

void Pyramid::clear() {
  for (const auto& [ticket, key] : in_progress_) workers_.cancel(ticket);
  nodes_.clear();
  nodes_by_level_.clear();
  recent_.clear();
  bytes_ = 0;
}

Pyramid::Node& Pyramid::nodeFor(const PyramidKey& key) {
  const auto [found, added] = nodes_.try_emplace(key);
  Node& node = found->second;
  if (added) {
    recent_.push_front(key);
    node.used = recent_.begin();
    ++nodes_by_level_[key.level];
    bytes_ += kNodeBytes;
  } else {
    recent_.splice(recent_.begin(), recent_, node.used);
  }
  node.round = round_;
  return node;
}

Pyramid::State Pyramid::setCurrent(Node& node, PyramidTilePtr tile) {
  bytes_ -= bytesOf(node.tile);
  node.tile = std::move(tile);
  bytes_ += bytesOf(node.tile);
  node.current = true;
  return State::Current;
}

Pyramid::State Pyramid::ask(const PyramidKey& key) {
  Node& node = nodeFor(key);
  if (node.current) return State::Current;
  if (node.ticket != 0) return State::Pending;
  if (!node.direct) {
    const double m_per_px = std::ldexp(base_m_per_px_, key.level);
    const auto finest_m = index_.finestWithin(gridOf(key, base_m_per_px_).bounds());
    if (!finest_m) return setCurrent(node, nullptr);
    node.direct = m_per_px <= kDirectCells * *finest_m * (1 + 1e-9) || m_per_px <= kFinestLevelM;
  }
  return *node.direct ? compose(key, node) : halve(key);
}

Pyramid::State Pyramid::compose(const PyramidKey& key, Node& node) {
  if (!workers_.hasRoom()) return State::Pending;
  const PixelGrid grid = gridOf(key, base_m_per_px_);
  node.ticket = workers_.start(work::Urgency::Wanted, [grid, textures = index_.within(grid.bounds()),
                                                       dense = dense_](const std::atomic<bool>& cancelled) {
    const Composition pixels =
        render::compose(grid, textures, Quality::Exact, *dense, Kernel::Best, &cancelled);
    return TileResult{nullptr, {}, pyramidTileOf(pixels)};
  });
  in_progress_.emplace(node.ticket, key);
  return State::Pending;
}

Pyramid::State Pyramid::halve(const PyramidKey& key) {
  std::array<PyramidTilePtr, 4> parts;
  bool complete = true;
  for (std::size_t p = 0; p < 4; ++p) {
    const PyramidKey part{key.level - 1, 2 * key.x + std::int64_t(p % 2), 2 * key.y + std::int64_t(p / 2)};
    if (ask(part) == State::Current) {
      parts[p] = nodes_.at(part).tile;
    } else {
      complete = false;
      if (!workers_.hasRoom()) return State::Pending;
    }
  }
  if (!complete) return State::Pending;
  Node& node = nodes_.at(key);  // requesting the parts may have moved it
  if (std::all_of(parts.begin(), parts.end(), [](const auto& part) { return !part; }))
    return setCurrent(node, nullptr);
  if (!workers_.hasRoom()) return State::Pending;
  node.ticket = workers_.start(work::Urgency::Wanted, [parts](const std::atomic<bool>&) {
    return TileResult{nullptr, {}, halved(parts)};
  });
  in_progress_.emplace(node.ticket, key);
  return State::Pending;
}

bool Pyramid::request(PyramidPatch& patch) {
  bool complete = true;
  for (int y = 0; y < patch.rows; ++y) {
    for (int x = 0; x < patch.columns; ++x) {
      const PyramidKey key{patch.first.level, patch.first.x + x, patch.first.y + y};
      if (ask(key) == State::Current) {
        patch.tiles[std::size_t(y * patch.columns + x)] = nodes_.at(key).tile;
      } else {
        complete = false;
      }
    }
  }
  return complete;
}

int Pyramid::missing(const PyramidPatch& patch) const {
  int missing = 0;
  for (int y = 0; y < patch.rows; ++y) {
    for (int x = 0; x < patch.columns; ++x) {
      const auto found = nodes_.find({patch.first.level, patch.first.x + x, patch.first.y + y});
      if (found == nodes_.end() || !found->second.current) ++missing;
    }
  }
  return missing;
}

void Pyramid::outdate(Node& node) {
  bytes_ -= bytesOf(node.tile) - kNodeBytes;
  node.tile.reset();
  node.current = false;
  node.direct.reset();
  if (node.ticket != 0) workers_.cancel(node.ticket);
  node.ticket = 0;
}

void Pyramid::invalidate(const std::vector<geometry::WorldRect>& rects) {
  if (nodes_.empty()) return;
  for (const auto& [level, count] : nodes_by_level_) {
    const double tile_m = std::ldexp(base_m_per_px_, level) * kTileEdge;
    for (const geometry::WorldRect& rect : rects) {
      if (rect.empty()) continue;
      const double x0 = tileCoordinate(rect.min_x / tile_m), x1 = tileCoordinate(rect.max_x / tile_m);
      const double y0 = tileCoordinate(-rect.max_y / tile_m), y1 = tileCoordinate(-rect.min_y / tile_m);
      if ((x1 - x0 + 1) * (y1 - y0 + 1) > double(nodes_.size())) {
        for (auto& [key, node] : nodes_) {
          if (key.level == level && double(key.x) >= x0 && double(key.x) <= x1 && double(key.y) >= y0 &&
              double(key.y) <= y1) {
            outdate(node);
          }
        }
        continue;
      }
      for (auto y = std::int64_t(y0); y <= std::int64_t(y1); ++y) {
        for (auto x = std::int64_t(x0); x <= std::int64_t(x1); ++x) {
          const auto found = nodes_.find({level, x, y});
          if (found != nodes_.end()) outdate(found->second);
        }
      }
    }
  }
}

std::optional<bool> Pyramid::onOutcome(const TileWorkers::Outcome& outcome) {
  const auto work = in_progress_.find(outcome.ticket);
  if (work == in_progress_.end()) return std::nullopt;
  const PyramidKey key = work->second;
  in_progress_.erase(work);
  const auto found = nodes_.find(key);
  const bool wanted = !outcome.cancelled && found != nodes_.end() && found->second.ticket == outcome.ticket;
  if (found != nodes_.end() && found->second.ticket == outcome.ticket) found->second.ticket = 0;
  if (wanted) setCurrent(found->second, outcome.result.tile);
  return wanted;
}

void Pyramid::trim(std::size_t budget_bytes) {
  auto at = recent_.end();
  while (bytes_ > budget_bytes && at != recent_.begin()) {
    --at;
    const auto found = nodes_.find(*at);
    // Rounds increase towards the front of the list.
    if (found->second.round == round_) return;
    if (found->second.ticket != 0) continue;
    bytes_ -= bytesOf(found->second.tile);
    if (--nodes_by_level_[at->level] == 0) nodes_by_level_.erase(at->level);
    nodes_.erase(found);
    at = recent_.erase(at);
  }
}

}  // namespace mapwright::render
