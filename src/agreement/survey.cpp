#include "agreement/survey.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <iterator>
#include <mutex>
#include <tuple>
#include <unordered_set>
#include <utility>

#include "agreement/faults.h"
#include "cells/cell_texture.h"

namespace mapwright::agreement {
namespace {

constexpr double kFarthestM = 1e7;
constexpr double kFinestTextureM = 1e-5;
constexpr double kMostTouched = 2e6;  // tiles, counted for each submap that touches them

bool sameContent(const render::PlacedTexture& a, const render::PlacedTexture& b) {
  return a.texture == b.texture && a.world_from_texture == b.world_from_texture;
}

bool placeable(const render::PlacedTexture& placed, const geometry::WorldRect& bounds) {
  if (!std::isfinite(placed.world_from_texture.yaw_rad) || placed.texture->resolutionM() < kFinestTextureM)
    return false;
  const auto near = [](double metres) { return std::abs(metres) <= kFarthestM; };  // false for NaN
  return near(bounds.min_x) && near(bounds.min_y) && near(bounds.max_x) && near(bounds.max_y);
}

/// The tiles whose reach touches `bounds`.
TileRange touchedBy(const geometry::WorldRect& bounds, const Rules& rules) {
  const geometry::WorldRect reach = bounds.grown(rules.tolerance_cells * rules.cell_m);
  const auto tileAt = [&](double metres) {
    return std::int32_t(std::floor(metres / (kTileCells * rules.cell_m)));
  };
  return {{tileAt(reach.min_x), tileAt(reach.min_y)}, {tileAt(reach.max_x), tileAt(reach.max_y)}};
}

using OfTile = std::pair<Square, const SquareFindings*>;  // a square may lie in several tiles

std::vector<Part> mostFirst(std::span<const OfTile> square) {
  std::map<map::SubmapId, Part> of_submaps;
  for (const auto& [where, findings] : square) {
    for (const Part& part : findings->submaps) {
      Part& sum = of_submaps.try_emplace(part.id, Part{part.id}).first->second;
      sum.occupied = std::uint16_t(sum.occupied + part.occupied);
      sum.free = std::uint16_t(sum.free + part.free);
    }
  }
  std::vector<Part> parts;
  for (const auto& [id, part] : of_submaps) parts.push_back(part);
  std::stable_sort(parts.begin(), parts.end(),
                   [](const Part& a, const Part& b) { return a.cells() > b.cells(); });
  return parts;
}

}  // namespace

std::vector<map::SubmapId> idsOf(std::span<const Part> submaps) {
  std::vector<map::SubmapId> ids;
  for (const Part& part : submaps) ids.push_back(part.id);
  return ids;
}

int Coverage::most() const {
  int most = Tile::kManySubmaps;
  while (most > 0 && cells_seen_by[std::size_t(most)] == 0) --most;
  return most;
}

std::vector<SeenPlace> seenPlaces(const Coverage& coverage) {
  std::map<Square, SeenPlace> squares;
  for (const auto& [key, tile] : coverage.tiles) {
    for (int row = 0; row < kTileCells; ++row) {
      SeenPlace* place = nullptr;
      Square of_place;
      for (int column = 0; column < kTileCells; ++column) {
        const int seen_by = tile->seenBy(column, row);
        if (seen_by == 0) continue;
        const Eigen::Vector2d centre = centreOf(key, column, row, coverage.cell_m);
        const Square square = squareAt(centre.x(), centre.y());
        if (!place || square != of_place) {
          place = &squares[square];
          of_place = square;
        }
        ++place->seen_cells;
        if (seen_by == 1) ++place->seen_once;
      }
    }
  }
  std::vector<SeenPlace> places;
  for (auto& [square, place] : squares) {
    place.x = square.x + 0.5;
    place.y = square.y + 0.5;
    places.push_back(place);
  }
  std::sort(places.begin(), places.end(), [](const SeenPlace& a, const SeenPlace& b) {
    return std::tuple(b.seen_once, a.y, a.x) < std::tuple(a.seen_once, b.y, b.x);
  });
  return places;
}

Disagreement disagreementOf(Tiles tiles, const Rules& rules, std::size_t most_places) {
  Disagreement found;
  found.cell_m = rules.cell_m;
  found.tolerance_cells = rules.tolerance_cells;
  std::vector<OfTile> all;
  for (const auto& [key, tile] : tiles) {
    found.occupied_cells += tile->occupied_cells;
    found.contradicted_cells += tile->contradicted_cells;
    for (const auto& [square, findings] : tile->squares) all.emplace_back(square, &findings);
  }
  std::sort(all.begin(), all.end(), [](const OfTile& a, const OfTile& b) { return a.first < b.first; });
  struct Candidate {
    std::span<const OfTile> of_tiles;
    std::uint64_t cells;
    auto rank() const {
      const Square square = of_tiles.front().first;
      return std::tuple(~cells, square.y, square.x);
    }
  };
  std::vector<Candidate> candidates;
  for (std::size_t first = 0, end = 0; first < all.size(); first = end) {
    std::uint64_t cells = 0;
    for (; end < all.size() && all[end].first == all[first].first; ++end) cells += all[end].second->cells;
    candidates.push_back({std::span(all).subspan(first, end - first), cells});
  }
  found.all_places = candidates.size();
  const std::size_t listed = std::min(most_places, candidates.size());
  std::partial_sort(candidates.begin(), candidates.begin() + std::ptrdiff_t(listed), candidates.end(),
                    [](const Candidate& a, const Candidate& b) { return a.rank() < b.rank(); });
  candidates.resize(listed);
  for (const Candidate& candidate : candidates) {
    const Square square = candidate.of_tiles.front().first;
    found.places.push_back({square.x + 0.5, square.y + 0.5, candidate.cells, mostFirst(candidate.of_tiles)});
  }
  found.tiles = std::move(tiles);
  return found;
}

bool Survey::InStrips::operator()(TileKey a, TileKey b) const {
  const auto order = [](TileKey key) { return std::tuple(key.row >> 2, key.column, key.row); };
  return order(a) < order(b);
}

Survey::Survey(Rules rules) : rules_(rules) {}

std::optional<Fault> Survey::setSubmaps(std::span<const render::PlacedTexture> submaps) {
  std::vector<map::SubmapId> unplaceable;
  std::unordered_set<map::SubmapId> placed_now;
  std::vector<Known> changed;  // new, or other than before
  for (const render::PlacedTexture& placed : submaps) {
    if (!placed.texture) continue;
    const geometry::WorldRect bounds = render::boundsOf(placed);
    if (!placeable(placed, bounds)) {
      unplaceable.push_back(placed.id);
      continue;
    }
    placed_now.insert(placed.id);
    const auto before = submaps_.find(placed.id);
    if (before == submaps_.end() || !sameContent(before->second.placed, placed))
      changed.push_back({placed, touchedBy(bounds, rules_)});
  }
  std::vector<map::SubmapId> gone;
  for (const auto& [id, known] : submaps_) {
    if (!placed_now.contains(id)) gone.push_back(id);
  }

  // Before anything is changed: how many submaps will touch each tile that is concerned.
  std::map<TileKey, std::int64_t> more;
  double touched = touched_;
  const Fault too_large(fault::TooLarge, {std::int64_t(kMostTiles), kTileCells * rules_.cell_m});
  const auto count = [&](const TileRange& range, std::int64_t by) {
    touched += double(by) * range.count();
    range.each([&](TileKey key) { more[key] += by; });
  };
  for (const map::SubmapId id : gone) count(submaps_.at(id).touches, -1);
  for (const Known& known : changed) {
    if (const auto before = submaps_.find(known.placed.id); before != submaps_.end())
      count(before->second.touches, -1);
  }
  for (const Known& known : changed) {
    if (known.touches.count() > double(kMostTiles) || touched + known.touches.count() > kMostTouched)
      return too_large;
    count(known.touches, 1);
  }
  std::size_t tiles = near_.size();
  for (const auto& [key, by] : more) {
    const auto found = near_.find(key);
    if (found == near_.end()) {
      tiles += by > 0 ? 1 : 0;
    } else if (std::int64_t(found->second.size()) + by == 0) {
      --tiles;
    }
  }
  if (tiles > kMostTiles) return too_large;

  touched_ = touched;
  unplaceable_ = std::move(unplaceable);
  const auto forget = [&](std::unordered_map<map::SubmapId, Known>::iterator at) {
    at->second.touches.each([&](TileKey key) { near_[key].erase(at->first); });
    submaps_.erase(at);
  };
  for (const map::SubmapId id : gone) forget(submaps_.find(id));
  for (Known& known : changed) {
    const map::SubmapId id = known.placed.id;
    if (const auto before = submaps_.find(id); before != submaps_.end()) forget(before);
    known.touches.each([&](TileKey key) { near_[key].insert(id); });
    submaps_.emplace(id, std::move(known));
  }
  for (const auto& [key, by] : more) {
    given_out_ -= generation_.erase(key);
    if (const auto near = near_.find(key); near->second.empty()) {
      near_.erase(near);
      stale_.erase(key);
      made_.erase(key);
    } else {
      stale_.insert(key);
    }
  }
  return std::nullopt;
}

std::optional<TileTask> Survey::take() {
  if (stale_.empty()) return std::nullopt;
  const TileKey key = *stale_.begin();
  stale_.erase(stale_.begin());
  TileTask task{key, rules_, {}, next_generation_++};
  for (const map::SubmapId id : near_.at(key)) task.near.push_back(submaps_.at(id).placed);
  generation_[key] = task.generation;
  ++given_out_;
  return task;
}

bool Survey::put(const TileTask& task, std::shared_ptr<const Tile> tile) {
  const auto given_out = generation_.find(task.key);
  if (given_out == generation_.end() || given_out->second != task.generation) return false;
  generation_.erase(given_out);
  --given_out_;
  if (!tile) {
    stale_.insert(task.key);
    return false;
  }
  if (tile->seen_cells > 0) {
    made_[task.key] = std::move(tile);
  } else {
    made_.erase(task.key);
  }
  return true;
}

bool Survey::makeAll(const std::shared_ptr<work::Workers>& workers, render::DenseCache& cache,
                     const std::function<bool(std::size_t made, std::size_t all)>& proceed) {
  struct Made {
    TileTask task;
    std::shared_ptr<const Tile> tile;
  };
  std::mutex mutex;
  std::condition_variable changed;
  std::vector<Made> results;
  std::atomic<bool> cancelled = false;
  std::map<TileKey, TileTask> in_progress;
  const std::size_t all = stale_.size(), most_in_progress = std::size_t(workers->threads()) * 4;
  std::size_t made = 0;
  work::Tasks tasks(workers);  // after what its jobs use
  while (!cancelled && (!stale_.empty() || !in_progress.empty())) {
    while (in_progress.size() < most_in_progress) {
      const std::optional<TileTask> task = take();
      if (!task) break;
      in_progress.emplace(task->key, *task);
      tasks.start(work::Urgency::Wanted, [&, task = *task] {
        std::shared_ptr<const Tile> tile = makeTile(task, cache, &cancelled);
        const std::lock_guard lock(mutex);
        results.push_back({task, std::move(tile)});
        changed.notify_one();
      });
    }
    std::vector<Made> ready;
    {
      std::unique_lock lock(mutex);
      changed.wait_for(lock, std::chrono::milliseconds(100), [&] { return !results.empty(); });
      ready.swap(results);
    }
    for (Made& one : ready) {
      in_progress.erase(one.task.key);
      if (put(one.task, std::move(one.tile))) ++made;
    }
    if (proceed && !proceed(made, all)) cancelled = true;
  }
  tasks.drop();
  tasks.waitForDone();
  for (const auto& [key, task] : in_progress) put(task, nullptr);
  return !cancelled;
}

Coverage Survey::coverage() const {
  Coverage found;
  found.cell_m = rules_.cell_m;
  found.tiles = made_;
  for (const auto& [key, tile] : made_) {
    found.seen_cells += tile->seen_cells;
    for (std::size_t count = 1; count < found.cells_seen_by.size(); ++count)
      found.cells_seen_by[count] += tile->cells_seen_by[count];
  }
  return found;
}

}  // namespace mapwright::agreement
