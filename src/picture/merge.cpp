#include "picture/merge.h"

#include <algorithm>
#include <cstring>

namespace mapwright::picture {

namespace {

std::int64_t differing(const std::uint8_t* one, const std::uint8_t* other) {
  std::int64_t count = 0;
  for (std::size_t row = 0; row < kTileCells; row += kEdge) {
    unsigned in_row = 0;
    for (std::size_t u = 0; u < kEdge; ++u) in_row += one[row + u] != other[row + u] ? 1 : 0;
    count += in_row;
  }
  return count;
}

std::int64_t differing(const EditedGrid& one, const EditedGrid& other, const TileKey& key) {
  if (one.own(key) == other.own(key)) return 0;
  const auto mine = one.tile(0, key.x, key.y), theirs = other.tile(0, key.x, key.y);
  return mine && theirs ? differing(mine->cells.get(), theirs->cells.get()) : 0;
}

/// The smallest rectangle around the differing cells of a tile; there is one.
CellRect differingRect(const std::uint8_t* one, const std::uint8_t* other) {
  CellRect rect;
  for (int v = 0; v < kEdge; ++v) {
    const std::uint8_t *a = one + std::size_t(v) * kEdge, *b = other + std::size_t(v) * kEdge;
    if (std::memcmp(a, b, kEdge) == 0) continue;
    const int left = int(std::mismatch(a, a + kEdge, b).first - a);
    int right = kEdge;
    while (a[right - 1] == b[right - 1]) --right;
    rect = rect.united({left, v, right, v + 1});
  }
  return rect;
}

/// Makes a tile of the canvas, whose cells are `now`, equal to `wanted`.
void overwrite(Canvas& canvas, const TileKey& key, const std::uint8_t* now, const std::uint8_t* wanted) {
  if (std::memcmp(now, wanted, kTileCells) == 0) return;
  std::memcpy(canvas.write(key.x, key.y, differingRect(now, wanted)), wanted, kTileCells);
}

/// The cell with that index in its tile.
CellRect cellAt(std::size_t at) {
  const int u = int(at % kEdge), v = int(at / kEdge);
  return {u, v, u + 1, v + 1};
}

}  // namespace

DifferenceCount::Tiles DifferenceCount::of(const Patch& touched) const {
  Tiles counts;
  for (const auto& [key, change] : touched.tiles) {
    if (key.level != 0) continue;
    const auto found = tiles.find(key);
    counts.emplace_back(key, found == tiles.end() ? 0 : found->second);
  }
  return counts;
}

DifferenceCount::Tiles DifferenceCount::counted(const EditedGrid& one, const EditedGrid& other,
                                                const Patch& touched) {
  Tiles counts;
  for (const auto& [key, change] : touched.tiles) {
    if (key.level == 0) counts.emplace_back(key, differing(one, other, key));
  }
  return counts;
}

void DifferenceCount::set(const TileKey& key, std::int64_t count) {
  if (const auto found = tiles.find(key); found != tiles.end()) {
    cells -= found->second;
    tiles.erase(found);
  }
  if (count == 0) return;
  cells += count;
  tiles[key] = count;
}

void DifferenceCount::set(const Tiles& counts) {
  for (const auto& [key, count] : counts) set(key, count);
}

void DifferenceCount::recount(const EditedGrid& one, const EditedGrid& other, const Patch& touched) {
  set(counted(one, other, touched));
}

DifferenceCount DifferenceCount::between(const EditedGrid& one, const EditedGrid& other) {
  DifferenceCount count;
  for (const EditedGrid* grid : {&one, &other}) {
    for (const TileKey& key : grid->changedTiles()) count.set(key, differing(one, other, key));
  }
  return count;
}

bool sameShape(const grids::GridPyramid& one, const grids::GridPyramid& other) {
  return one.width() == other.width() && one.height() == other.height() && one.code() == other.code();
}

Patch differenceTo(const EditedGrid& grid, const grids::GridPyramid& other,
                   const std::atomic<bool>* cancelled) {
  Canvas canvas(grid);
  const int columns = (grid.width() + kEdge - 1) / kEdge, rows = (grid.height() + kEdge - 1) / kEdge;
  for (int y = 0; y < rows; ++y) {
    if (cancelled && cancelled->load(std::memory_order_relaxed)) return {};
    for (int x = 0; x < columns; ++x) {
      const auto now = grid.tile(0, x, y), wanted = other.tile(0, x, y);
      if (!now || !wanted || now->cells == wanted->cells) continue;
      overwrite(canvas, {0, x, y}, now->cells.get(), wanted->cells.get());
    }
  }
  return canvas.take();
}

Changes changesOf(const EditedGrid& grid, const Patch& patch, std::size_t most_runs) {
  const auto kinds = kindsOf(grid.code());
  Changes changes;
  for (const auto& [key, change] : patch.tiles) {
    if (key.level != 0) continue;
    const auto before = grid.tile(0, key.x, key.y);
    const auto cells = change.after.cells ? change.after.cells : grid.base()->tile(0, key.x, key.y)->cells;
    const std::uint8_t *was = before->cells.get(), *is = cells.get();
    for (int v = 0; v < kEdge; ++v, was += kEdge, is += kEdge) {
      if (std::memcmp(was, is, kEdge) == 0) continue;
      for (int u = 0; u < kEdge; ++u) {
        if (was[u] == is[u]) continue;
        const int from = u;
        const Kind becomes = kinds[is[u]];
        while (u + 1 < kEdge && was[u + 1] != is[u + 1] && kinds[is[u + 1]] == becomes) ++u;
        changes.become[std::size_t(becomes)] += u + 1 - from;
        changes.all = changes.runs.size() < most_runs;
        if (changes.all)
          changes.runs.push_back(
              {CellRect{from, v, u + 1, v + 1}.moved(key.x * kEdge, key.y * kEdge), becomes});
      }
    }
  }
  return changes;
}

void CellSet::unite(const CellSet& other) {
  for (const auto& [key, cells] : other.tiles) tiles[key] |= cells;
}

std::pair<std::int64_t, CellRect> CellSet::differing(const EditedGrid& one, const EditedGrid& other) const {
  std::int64_t count = 0;
  CellRect where;
  for (const auto& [key, cells] : tiles) {
    const auto a = one.tile(0, key.x, key.y), b = other.tile(0, key.x, key.y);
    if (!a || !b || a->cells == b->cells) continue;
    for (std::size_t at = 0; at < kTileCells; ++at) {
      if (!cells[at] || a->cells.get()[at] == b->cells.get()[at]) continue;
      ++count;
      where = where.united(cellAt(at).moved(key.x * kEdge, key.y * kEdge));
    }
  }
  return {count, where};
}

Patch copied(const EditedGrid& grid, const EditedGrid& source, const CellSet& cells) {
  Canvas canvas(grid);
  for (const auto& [key, of_tile] : cells.tiles) {
    const auto from = source.tile(0, key.x, key.y);
    if (!from) continue;
    for (std::size_t at = 0; at < kTileCells; ++at) {
      const std::uint8_t wanted = from->cells.get()[at];
      if (!of_tile[at] || canvas.read(key.x, key.y)[at] == wanted) continue;
      canvas.write(key.x, key.y, cellAt(at))[at] = wanted;
    }
  }
  return canvas.take();
}

Merge mergeCells(const EditedGrid& mine, const Patch& theirs, const EditedGrid& base) {
  Merge merge;
  Canvas canvas(mine);
  for (const auto& [key, change] : theirs.tiles) {
    if (key.level != 0 || !change.after.cells) continue;
    const auto before = base.tile(0, key.x, key.y);
    if (!before) continue;
    const std::uint8_t *was = before->cells.get(), *their = change.after.cells.get();
    const std::uint8_t* my = canvas.read(key.x, key.y);
    std::uint8_t* out = nullptr;
    for (std::size_t at = 0; at < kTileCells; ++at) {
      if (their[at] == was[at] || their[at] == my[at]) continue;
      if (my[at] != was[at]) {
        merge.conflicts.tiles[key].set(at);
        continue;
      }
      ++merge.taken;
      out = canvas.write(key.x, key.y, cellAt(at));
      my = out;
      out[at] = their[at];
    }
  }
  merge.patch = canvas.take();
  return merge;
}

Rebase::Rebase(const Patch& theirs, std::shared_ptr<const EditedGrid> base) : base_(std::move(base)) {
  for (const auto& [key, change] : theirs.tiles) {
    if (key.level == 0 && change.after.cells) theirs_[key] = change.after;
  }
}

void Rebase::know(const Merge& merge) {
  for (const auto& [key, change] : merge.patch.tiles) {
    if (key.level == 0) made_[{key, change.before.cells.get()}] = {change.before, change.after};
  }
}

TileState Rebase::rebased(const TileKey& key, const TileState& state) {
  const auto their = theirs_.find(key);
  if (their == theirs_.end()) return state;
  Made& made = made_[{key, state.cells.get()}];
  if (made.to.cells) return made.to;
  made = {state, state};
  const auto was = base_->tile(0, key.x, key.y);
  const auto my = state.cells ? std::optional(grids::GridTile{state.cells, state.uniform, false})
                              : base_->base()->tile(0, key.x, key.y);
  if (!was || !my) return state;
  if (my->cells == was->cells || std::memcmp(my->cells.get(), was->cells.get(), kTileCells) == 0)
    return made.to = their->second;
  std::shared_ptr<std::uint8_t[]> out;
  for (std::size_t at = 0; at < kTileCells; ++at) {
    const std::uint8_t now = my->cells.get()[at], before = was->cells.get()[at],
                       theirs = their->second.cells.get()[at];
    if (now != before || theirs == now) continue;
    if (!out) {
      out = std::make_shared_for_overwrite<std::uint8_t[]>(kTileCells);
      std::memcpy(out.get(), my->cells.get(), kTileCells);
    }
    out[at] = theirs;
  }
  if (out) {
    const bool uniform = std::memcmp(out.get(), out.get() + 1, kTileCells - 1) == 0;
    made.to = {std::shared_ptr<const std::uint8_t>(out, out.get()), uniform};
  }
  return made.to;
}

void Rebase::apply(Patch& patch) {
  std::map<TileKey, TileChange> finest;
  bool touched = false;
  for (const auto& [key, change] : patch.tiles) {
    if (key.level != 0) break;  // they are sorted
    finest[key] = {rebased(key, change.before), rebased(key, change.after)};
  }
  // A coarser tile also depends on its surroundings.
  for (const auto& [key, their] : theirs_) {
    for (TileKey under = key; !touched && under.level < base_->levels();
         under = {under.level + 1, under.x / 2, under.y / 2})
      touched = patch.tiles.contains(under);
  }
  if (!touched) return;
  patch.tiles = std::move(finest);
  patch.finest_only = true;
}

Patch withCoarserLevels(const EditedGrid& grid, const Patch& patch, bool done) {
  Canvas canvas(grid);
  for (const auto& [key, change] : patch.tiles) {
    if (key.level != 0) continue;
    const TileState& wanted = done ? change.before : change.after;
    const auto cells = wanted.cells ? wanted.cells : grid.base()->tile(0, key.x, key.y)->cells;
    const auto now = grid.tile(0, key.x, key.y);
    overwrite(canvas, key, now->cells.get(), cells.get());
  }
  Patch made = canvas.take();
  for (auto& [key, change] : made.tiles) {
    // Reuses the existing tile, so that steps share memory.
    if (key.level == 0) change.after = done ? patch.tiles.at(key).before : patch.tiles.at(key).after;
    if (done) std::swap(change.before, change.after);
  }
  return made;
}

}  // namespace mapwright::picture
