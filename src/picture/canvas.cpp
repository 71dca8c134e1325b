#include "picture/canvas.h"

#include <algorithm>
#include <cstring>
#include <map>

namespace mapwright::picture {

namespace {

bool allSame(const std::uint8_t* cells, std::size_t count) {
  return std::memcmp(cells, cells + 1, count - 1) == 0;
}

bool alreadyIs(const std::uint8_t* cells, std::size_t count, std::uint8_t byte) {
  return cells[0] == byte && (count == 1 || allSame(cells, count));
}

}  // namespace

Canvas::Canvas(const EditedGrid& grid) : grid_(grid), reducer_(grid.code(), grid.reduction()) {}

Canvas::Sheet& Canvas::sheet(int tile_x, int tile_y) {
  const Key key = keyOf(tile_x, tile_y);
  if (last_ && last_key_ == key) return *last_;
  Sheet& found = sheets_[key];
  if (!found.read.cells) {
    auto tile = grid_.tile(0, tile_x, tile_y);
    if (tile) {
      found.read = std::move(*tile);
    } else {
      auto blank = std::make_shared<std::uint8_t[]>(kTileCells, grids::unknownByte(grid_.code()));
      found.read = {std::shared_ptr<const std::uint8_t>(blank, blank.get()), true, false};
    }
  }
  last_key_ = key;
  last_ = &found;
  return found;
}

const std::uint8_t* Canvas::read(int tile_x, int tile_y) {
  const Sheet& found = sheet(tile_x, tile_y);
  return found.wrote ? found.wrote.get() : found.read.cells.get();
}

bool Canvas::uniform(int tile_x, int tile_y) {
  const Sheet& found = sheet(tile_x, tile_y);
  return !found.wrote && found.read.uniform;
}

std::uint8_t* Canvas::write(int tile_x, int tile_y, const CellRect& within) {
  Sheet& found = sheet(tile_x, tile_y);
  if (!found.wrote) {
    found.wrote = std::make_shared_for_overwrite<std::uint8_t[]>(kTileCells);
    std::memcpy(found.wrote.get(), found.read.cells.get(), kTileCells);
  }
  found.dirty = found.dirty.united(within);
  touched_ = touched_.united(within.moved(tile_x * Canvas::kEdge, tile_y * Canvas::kEdge));
  return found.wrote.get();
}

void Canvas::paintRow(int row, int from, int to, const Ink& ink) {
  from = std::max(from, 0);
  to = std::min(to, grid_.width());
  if (row < 0 || row >= grid_.height() || from >= to) return;
  const int tile_y = row / Canvas::kEdge, v = row % Canvas::kEdge;
  for (int tile_x = from / Canvas::kEdge; tile_x * Canvas::kEdge < to; ++tile_x) {
    const int u0 = std::max(from - tile_x * Canvas::kEdge, 0),
              u1 = std::min(to - tile_x * Canvas::kEdge, Canvas::kEdge);
    const std::size_t at = std::size_t(v) * Canvas::kEdge + std::size_t(u0), count = std::size_t(u1 - u0);
    const std::uint8_t* const now = read(tile_x, tile_y) + at;
    if (ink.from) {
      const auto source = ink.from->tile(0, tile_x, tile_y);
      if (!source || std::memcmp(now, source->cells.get() + at, count) == 0) continue;
      std::memcpy(write(tile_x, tile_y, {u0, v, u1, v + 1}) + at, source->cells.get() + at, count);
    } else if (!alreadyIs(now, count, ink.byte)) {
      std::memset(write(tile_x, tile_y, {u0, v, u1, v + 1}) + at, ink.byte, count);
    }
  }
}

void Canvas::putRow(int row, int from, int to, const std::uint8_t* bytes) {
  const int begin = std::max(from, 0), end = std::min(to, grid_.width());
  if (row < 0 || row >= grid_.height() || begin >= end) return;
  const int tile_y = row / Canvas::kEdge, v = row % Canvas::kEdge;
  for (int tile_x = begin / Canvas::kEdge; tile_x * Canvas::kEdge < end; ++tile_x) {
    const int u0 = std::max(begin - tile_x * Canvas::kEdge, 0),
              u1 = std::min(end - tile_x * Canvas::kEdge, Canvas::kEdge);
    const std::size_t at = std::size_t(v) * Canvas::kEdge + std::size_t(u0), count = std::size_t(u1 - u0);
    const std::uint8_t* const wanted = bytes + (tile_x * Canvas::kEdge + u0 - from);
    if (std::memcmp(read(tile_x, tile_y) + at, wanted, count) == 0) continue;
    std::memcpy(write(tile_x, tile_y, {u0, v, u1, v + 1}) + at, wanted, count);
  }
}

TileState Canvas::stateOf(std::shared_ptr<std::uint8_t[]> cells) {
  std::uint8_t* const bytes = cells.get();
  if (!allSame(bytes, kTileCells)) return {std::shared_ptr<const std::uint8_t>(cells, bytes), false};
  auto& shared = uniform_[*bytes];
  if (!shared) shared = std::shared_ptr<const std::uint8_t>(cells, bytes);
  return {shared, true};
}

std::shared_ptr<std::uint8_t[]> Canvas::copyOf(const TilePlace& place) const {
  auto copy = std::make_shared_for_overwrite<std::uint8_t[]>(kTileCells);
  if (const auto tile = grid_.tile(place.level, place.x, place.y)) {
    std::memcpy(copy.get(), tile->cells.get(), kTileCells);
  } else {
    std::memset(copy.get(), grids::unknownByte(grid_.code()), kTileCells);
  }
  return copy;
}

/// The tiles of the next level below the changed ones, reduced where they changed.
std::vector<Canvas::Changed> Canvas::reduced(const std::vector<Changed>& finer, Patch& patch) {
  struct Coarse {
    std::shared_ptr<std::uint8_t[]> cells;
    CellRect dirty;
  };
  std::map<TilePlace, Coarse> coarse;
  for (const Changed& fine : finer) {
    const int level = fine.place.level;
    const TilePlace place{level + 1, fine.place.x / 2, fine.place.y / 2};
    Coarse& under = coarse[place];
    if (!under.cells) under.cells = copyOf(place);
    const int width = std::min(Canvas::kEdge, grid_.levelWidth(level) - fine.place.x * Canvas::kEdge);
    const int height = std::min(Canvas::kEdge, grid_.levelHeight(level) - fine.place.y * Canvas::kEdge);
    const CellRect part{fine.dirty.left & ~1, fine.dirty.top & ~1,
                        std::min((fine.dirty.right + 1) & ~1, width),
                        std::min((fine.dirty.bottom + 1) & ~1, height)};
    const int shift_x = fine.place.x % 2 * (Canvas::kEdge / 2),
              shift_y = fine.place.y % 2 * (Canvas::kEdge / 2);
    for (int v = part.top; v < part.bottom; v += 2) {
      const std::uint8_t* const upper = fine.cells + std::size_t(v) * Canvas::kEdge + std::size_t(part.left);
      const std::uint8_t* const lower = v + 1 < height ? upper + Canvas::kEdge : upper;
      reducer_.reduceRow(upper, lower, std::size_t(part.width()),
                         under.cells.get() + std::size_t(v / 2 + shift_y) * Canvas::kEdge +
                             std::size_t(part.left / 2 + shift_x));
    }
    under.dirty = under.dirty.united({part.left / 2 + shift_x, part.top / 2 + shift_y,
                                      (part.right + 1) / 2 + shift_x, (part.bottom + 1) / 2 + shift_y});
  }
  std::vector<Changed> next;
  next.reserve(coarse.size());
  for (auto& [place, made] : coarse) {
    const TileState after = stateOf(std::move(made.cells));
    patch.tiles[place] = {grid_.own(place), after};
    next.push_back({place, after.cells.get(), made.dirty});
  }
  return next;
}

Patch Canvas::take() {
  Patch patch;
  std::vector<Changed> changed;
  for (auto& [key, written] : sheets_) {
    if (!written.wrote) continue;
    const TilePlace place{0, int(key & 0xffffffff), int(key >> 32)};
    const TileState after = stateOf(std::move(written.wrote));
    patch.tiles[place] = {grid_.own(place), after};
    changed.push_back({place, after.cells.get(), written.dirty});
  }
  for (int level = 1; level < grid_.levels() && !changed.empty(); ++level) changed = reduced(changed, patch);
  patch.cells = touched_;
  sheets_.clear();
  last_ = nullptr;
  touched_ = {};
  return patch;
}

}  // namespace mapwright::picture
