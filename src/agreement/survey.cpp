#include "agreement/survey.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <iterator>
#include <mutex>
#include <tuple>
#include <utility>

#include "agreement/faults.h"

namespace mapwright::agreement {
namespace {

constexpr double kFarthestM = 1e7;
constexpr double kFinestTextureM = 1e-5;
constexpr std::size_t kMostTouched = 2'000'000;  // tiles, counted for each submap that touches them

bool sameContent(const render::PlacedTexture& a, const render::PlacedTexture& b) {
  return a.texture == b.texture && a.world_from_texture == b.world_from_texture;
}

bool placeable(const render::PlacedTexture& placed, const geometry::WorldRect& bounds) {
  if (!std::isfinite(placed.world_from_texture.yaw_rad) || placed.texture->resolutionM() < kFinestTextureM)
    return false;
  const auto near = [](double metres) { return std::abs(metres) <= kFarthestM; };  // false for NaN
  return near(bounds.min_x) && near(bounds.min_y) && near(bounds.max_x) && near(bounds.max_y);
}

/// The tiles whose reach touches `bounds`: columns and rows, the last ones included.
struct TileRange {
  TileKey first, last;
  double count() const {
    return (double(last.column) - first.column + 1) * (double(last.row) - first.row + 1);
  }
};

TileRange touchedBy(const geometry::WorldRect& bounds, const Rules& rules) {
  const geometry::WorldRect reach = bounds.grown(rules.tolerance_cells * rules.cell_m);
  const auto tileAt = [&](double metres) {
    return std::int32_t(std::floor(metres / (kTileCells * rules.cell_m)));
  };
  return {{tileAt(reach.min_x), tileAt(reach.min_y)}, {tileAt(reach.max_x), tileAt(reach.max_y)}};
}

}  // namespace

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

bool Survey::InStrips::operator()(TileKey a, TileKey b) const {
  const auto order = [](TileKey key) { return std::tuple(key.row >> 2, key.column, key.row); };
  return order(a) < order(b);
}

Survey::Survey(Rules rules) : rules_(rules) {}

std::optional<Fault> Survey::setSubmaps(std::span<const render::PlacedTexture> submaps) {
  std::unordered_map<map::SubmapId, Known> now;
  std::vector<map::SubmapId> unplaceable;
  std::set<TileKey> all;
  std::set<TileKey> changed;
  std::size_t touched = 0;
  const Fault too_large(fault::TooLarge, {std::int64_t(kMostTiles), kTileCells * rules_.cell_m});
  for (const render::PlacedTexture& placed : submaps) {
    if (!placed.texture) continue;
    const geometry::WorldRect bounds = render::boundsOf(placed);
    if (!placeable(placed, bounds)) {
      unplaceable.push_back(placed.id);
      continue;
    }
    Known known{placed, {}};
    const auto before = submaps_.find(placed.id);
    const bool same = before != submaps_.end() && sameContent(before->second.placed, placed);
    if (same) {
      known.touches = before->second.touches;
    } else {
      const TileRange range = touchedBy(bounds, rules_);
      if (range.count() > double(kMostTiles)) return too_large;
      for (std::int32_t row = range.first.row; row <= range.last.row; ++row) {
        for (std::int32_t column = range.first.column; column <= range.last.column; ++column)
          known.touches.push_back({column, row});
      }
      changed.insert(known.touches.begin(), known.touches.end());
    }
    all.insert(known.touches.begin(), known.touches.end());
    touched += known.touches.size();
    if (all.size() > kMostTiles || touched > kMostTouched) return too_large;
    now.insert_or_assign(placed.id, std::move(known));
  }
  for (const auto& [id, known] : submaps_) {
    const auto after = now.find(id);
    if (after == now.end() || !sameContent(after->second.placed, known.placed))
      changed.insert(known.touches.begin(), known.touches.end());
  }
  submaps_ = std::move(now);
  unplaceable_ = std::move(unplaceable);
  near_.clear();
  for (const auto& [id, known] : submaps_) {
    for (const TileKey key : known.touches) near_[key].insert(id);
  }
  for (const TileKey key : changed) {
    given_out_ -= generation_.erase(key);
    if (near_.contains(key)) {
      stale_.insert(key);
    } else {
      stale_.erase(key);
      made_.erase(key);
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

Disagreement Survey::disagreement() const {
  Disagreement found;
  found.cell_m = rules_.cell_m;
  found.tolerance_cells = rules_.tolerance_cells;
  found.tiles = made_;
  std::map<Square, SquareFindings> squares;
  for (const auto& [key, tile] : made_) {
    found.occupied_cells += tile->occupied_cells;
    found.contradicted_cells += tile->contradicted_cells;
    for (const auto& [square, findings] : tile->squares) {
      SquareFindings& sum = squares[square];
      sum.cells += findings.cells;
      std::vector<map::SubmapId> merged;
      std::set_union(sum.submaps.begin(), sum.submaps.end(), findings.submaps.begin(), findings.submaps.end(),
                     std::back_inserter(merged));
      sum.submaps = std::move(merged);
    }
  }
  for (auto& [square, findings] : squares)
    found.places.push_back({square.x + 0.5, square.y + 0.5, findings.cells, std::move(findings.submaps)});
  std::sort(found.places.begin(), found.places.end(), [](const Place& a, const Place& b) {
    return std::tuple(b.cells, a.y, a.x) < std::tuple(a.cells, b.y, b.x);
  });
  return found;
}

Coverage Survey::coverage() const {
  Coverage found;
  found.cell_m = rules_.cell_m;
  found.tiles = made_;
  for (const auto& [key, tile] : made_) {
    found.seen_cells += tile->seen_cells;
    for (const std::uint8_t count : tile->seen_by) ++found.cells_seen_by[count];
  }
  found.cells_seen_by[0] = 0;
  return found;
}

}  // namespace mapwright::agreement
