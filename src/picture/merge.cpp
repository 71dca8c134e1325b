#include "picture/merge.h"

#include <algorithm>
#include <cstring>

namespace mapwright::picture {

namespace {

constexpr int kEdge = Canvas::kEdge;
constexpr std::size_t kTileCells = std::size_t(kEdge) * kEdge;

std::int64_t differing(const std::uint8_t* one, const std::uint8_t* other) {
  std::int64_t count = 0;
  for (std::size_t row = 0; row < kTileCells; row += kEdge) {
    unsigned in_row = 0;
    for (std::size_t u = 0; u < kEdge; ++u) in_row += one[row + u] != other[row + u] ? 1 : 0;
    count += in_row;
  }
  return count;
}

std::int64_t differing(const EditedGrid& one, const EditedGrid& other, const TilePlace& place) {
  if (one.own(place) == other.own(place)) return 0;
  const auto mine = one.tile(0, place.x, place.y), theirs = other.tile(0, place.x, place.y);
  return mine && theirs ? differing(mine->cells.get(), theirs->cells.get()) : 0;
}

/// The least rectangle around the cells of a tile that differ; there is one.
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

}  // namespace

DifferenceCount::Tiles DifferenceCount::of(const Patch& touched) const {
  Tiles counts;
  for (const auto& [place, change] : touched.tiles) {
    if (place.level != 0) continue;
    const auto found = tiles.find(place);
    counts.emplace_back(place, found == tiles.end() ? 0 : found->second);
  }
  return counts;
}

DifferenceCount::Tiles DifferenceCount::counted(const EditedGrid& one, const EditedGrid& other,
                                                const Patch& touched) {
  Tiles counts;
  for (const auto& [place, change] : touched.tiles) {
    if (place.level == 0) counts.emplace_back(place, differing(one, other, place));
  }
  return counts;
}

void DifferenceCount::set(const TilePlace& place, std::int64_t count) {
  if (const auto found = tiles.find(place); found != tiles.end()) {
    cells -= found->second;
    tiles.erase(found);
  }
  if (count == 0) return;
  cells += count;
  tiles[place] = count;
}

void DifferenceCount::set(const Tiles& counts) {
  for (const auto& [place, count] : counts) set(place, count);
}

void DifferenceCount::recount(const EditedGrid& one, const EditedGrid& other, const Patch& touched) {
  set(counted(one, other, touched));
}

DifferenceCount DifferenceCount::between(const EditedGrid& one, const EditedGrid& other) {
  DifferenceCount count;
  for (const EditedGrid* grid : {&one, &other}) {
    for (const TilePlace& place : grid->changedTiles()) count.set(place, differing(one, other, place));
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
      if (std::memcmp(now->cells.get(), wanted->cells.get(), kTileCells) == 0) continue;
      const CellRect rect = differingRect(now->cells.get(), wanted->cells.get());
      std::memcpy(canvas.write(x, y, rect), wanted->cells.get(), kTileCells);
    }
  }
  return canvas.take();
}

std::vector<CellRect> changedRuns(const EditedGrid& grid, const Patch& patch, std::size_t most) {
  std::vector<CellRect> runs;
  for (const auto& [place, change] : patch.tiles) {
    if (place.level != 0 || !change.after.cells) continue;
    const auto before = grid.tile(0, place.x, place.y);
    if (!before) continue;
    const std::uint8_t *was = before->cells.get(), *is = change.after.cells.get();
    for (int v = 0; v < kEdge; ++v, was += kEdge, is += kEdge) {
      if (std::memcmp(was, is, kEdge) == 0) continue;
      for (int u = 0; u < kEdge; ++u) {
        if (was[u] == is[u]) continue;
        const int from = u;
        while (u + 1 < kEdge && was[u + 1] != is[u + 1]) ++u;
        if (runs.size() == most) return runs;
        runs.push_back(CellRect{from, v, u + 1, v + 1}.moved(place.x * kEdge, place.y * kEdge));
      }
    }
  }
  return runs;
}

Merge mergeCells(const EditedGrid& mine, const Patch& theirs, const EditedGrid& base, bool take_theirs) {
  Merge merge;
  Canvas canvas(mine);
  for (const auto& [place, change] : theirs.tiles) {
    if (place.level != 0 || !change.after.cells) continue;
    const auto before = base.tile(0, place.x, place.y);
    if (!before) continue;
    const std::uint8_t *was = before->cells.get(), *their = change.after.cells.get();
    const std::uint8_t* my = canvas.read(place.x, place.y);
    std::uint8_t* out = nullptr;
    for (std::size_t at = 0; at < kTileCells; ++at) {
      if (their[at] == was[at] || their[at] == my[at]) continue;
      const int u = int(at % kEdge), v = int(at / kEdge);
      const bool conflict = my[at] != was[at];
      if (conflict) {
        ++merge.conflicts;
        merge.where =
            merge.where.united(CellRect{u, v, u + 1, v + 1}.moved(place.x * kEdge, place.y * kEdge));
        if (!take_theirs) continue;
      }
      ++merge.taken;
      out = canvas.write(place.x, place.y, {u, v, u + 1, v + 1});
      my = out;
      out[at] = their[at];
    }
  }
  merge.patch = canvas.take();
  return merge;
}

}  // namespace mapwright::picture
