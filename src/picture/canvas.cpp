#include "picture/canvas.h"

#include <algorithm>
#include <cstring>
#include <map>

namespace mapwright::picture {
namespace {

constexpr std::uint8_t kFreeGray = 255, kOccupiedGray = 0, kFreePercent = 0, kOccupiedPercent = 100;
constexpr int kOccupiedFrom = 50;

bool allSame(const std::uint8_t* cells, std::size_t count) {
  return std::memcmp(cells, cells + 1, count - 1) == 0;
}

bool alreadyIs(const std::uint8_t* cells, std::size_t count, std::uint8_t byte) {
  return cells[0] == byte && (count == 1 || allSame(cells, count));
}

}  // namespace

std::array<Kind, 256> kindsOf(grids::CellCode code) {
  const grids::CellMeaning& meaning = grids::meaningOf(code);
  std::array<Kind, 256> kinds{};
  for (std::size_t byte = 0; byte < kinds.size(); ++byte) {
    kinds[byte] = !meaning.known[byte]                       ? Kind::Unknown
                  : meaning.occupancy[byte] >= kOccupiedFrom ? Kind::Occupied
                                                             : Kind::Free;
  }
  return kinds;
}

std::optional<std::uint8_t> byteOf(Kind kind, grids::CellCode code) {
  switch (kind) {
    case Kind::Free:
      return grids::isGray(code) ? kFreeGray : kFreePercent;
    case Kind::Occupied:
      return grids::isGray(code) ? kOccupiedGray : kOccupiedPercent;
    case Kind::Unknown:
      break;
  }
  if (code == grids::CellCode::FullGray) return std::nullopt;
  return grids::unknownByte(code);
}

std::optional<std::uint8_t> firstOther(const grids::GridPyramid& cells, const std::array<bool, 256>& held,
                                       const std::atomic<bool>& cancelled) {
  for (int y = 0; y * kEdge < cells.height() && !cancelled; ++y) {
    for (int x = 0; x * kEdge < cells.width(); ++x) {
      const auto tile = cells.tile(0, x, y);
      if (!tile) continue;
      const int right = std::min(kEdge, cells.width() - x * kEdge),
                bottom = std::min(kEdge, cells.height() - y * kEdge);
      for (int v = 0; v < (tile->uniform ? 1 : bottom); ++v) {
        const std::uint8_t* const row = tile->cells.get() + std::size_t(v) * kEdge;
        const std::uint8_t* const other =
            std::find_if(row, row + right, [&held](std::uint8_t byte) { return !held[byte]; });
        if (other != row + right) return *other;
      }
    }
  }
  return std::nullopt;
}

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

std::uint8_t* Canvas::write(int tile_x, int tile_y, const CellRect& within) {
  Sheet& found = sheet(tile_x, tile_y);
  if (!found.wrote) {
    found.wrote = std::make_shared_for_overwrite<std::uint8_t[]>(kTileCells);
    std::memcpy(found.wrote.get(), found.read.cells.get(), kTileCells);
  }
  found.dirty = found.dirty.united(within);
  touched_ = touched_.united(within.moved(tile_x * kEdge, tile_y * kEdge));
  return found.wrote.get();
}

/// Calls visit(tile_x, piece, at) for each tile that a row crosses: the cells of that tile, and the index of
/// the first of them.
template <typename Visit>
void Canvas::eachPiece(int row, int from, int to, Visit visit) {
  from = std::max(from, 0);
  to = std::min(to, grid_.width());
  if (row < 0 || row >= grid_.height()) return;
  const int v = row % kEdge;
  for (int tile_x = from / kEdge; tile_x * kEdge < to; ++tile_x) {
    const int left = std::max(from - tile_x * kEdge, 0), right = std::min(to - tile_x * kEdge, kEdge);
    if (left < right)
      visit(tile_x, CellRect{left, v, right, v + 1}, std::size_t(v) * kEdge + std::size_t(left));
  }
}

void Canvas::paintRow(int row, int from, int to, const Ink& ink) {
  const int tile_y = row / kEdge;
  eachPiece(row, from, to, [&](int tile_x, const CellRect& piece, std::size_t at) {
    const std::size_t count = std::size_t(piece.width());
    const std::uint8_t* const now = read(tile_x, tile_y) + at;
    if (ink.from) {
      const auto source = ink.from->tile(0, tile_x, tile_y);
      if (!source || std::memcmp(now, source->cells.get() + at, count) == 0) return;
      std::memcpy(write(tile_x, tile_y, piece) + at, source->cells.get() + at, count);
    } else if (!alreadyIs(now, count, ink.byte)) {
      std::memset(write(tile_x, tile_y, piece) + at, ink.byte, count);
    }
  });
}

void Canvas::putRow(int row, int from, int to, const std::uint8_t* bytes) {
  const int tile_y = row / kEdge;
  eachPiece(row, from, to, [&](int tile_x, const CellRect& piece, std::size_t at) {
    const std::uint8_t* const wanted = bytes + (tile_x * kEdge + piece.left - from);
    const std::size_t count = std::size_t(piece.width());
    if (std::memcmp(read(tile_x, tile_y) + at, wanted, count) != 0)
      std::memcpy(write(tile_x, tile_y, piece) + at, wanted, count);
  });
}

void Canvas::getRow(int row, int from, int to, std::uint8_t* bytes) {
  eachPiece(row, from, to, [&](int tile_x, const CellRect& piece, std::size_t at) {
    std::memcpy(bytes + (tile_x * kEdge + piece.left - from), read(tile_x, row / kEdge) + at,
                std::size_t(piece.width()));
  });
}

TileState Canvas::stateOf(std::shared_ptr<std::uint8_t[]> cells) {
  std::uint8_t* const bytes = cells.get();
  if (!allSame(bytes, kTileCells)) return {std::shared_ptr<const std::uint8_t>(cells, bytes), false};
  auto& shared = uniform_[*bytes];
  if (!shared) shared = std::shared_ptr<const std::uint8_t>(cells, bytes);
  return {shared, true};
}

std::shared_ptr<std::uint8_t[]> Canvas::copyOf(const TileKey& key) const {
  auto copy = std::make_shared_for_overwrite<std::uint8_t[]>(kTileCells);
  if (const auto tile = grid_.tile(key.level, key.x, key.y)) {
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
  std::map<TileKey, Coarse> coarse;
  for (const Changed& fine : finer) {
    const int level = fine.key.level;
    const TileKey key{level + 1, fine.key.x / 2, fine.key.y / 2};
    Coarse& under = coarse[key];
    if (!under.cells) under.cells = copyOf(key);
    const int width = std::min(kEdge, grid_.levelWidth(level) - fine.key.x * kEdge);
    const int height = std::min(kEdge, grid_.levelHeight(level) - fine.key.y * kEdge);
    const CellRect part{fine.dirty.left & ~1, fine.dirty.top & ~1,
                        std::min((fine.dirty.right + 1) & ~1, width),
                        std::min((fine.dirty.bottom + 1) & ~1, height)};
    const int shift_x = fine.key.x % 2 * (kEdge / 2), shift_y = fine.key.y % 2 * (kEdge / 2);
    for (int v = part.top; v < part.bottom; v += 2) {
      const std::uint8_t* const upper = fine.cells + std::size_t(v) * kEdge + std::size_t(part.left);
      const std::uint8_t* const lower = v + 1 < height ? upper + kEdge : upper;
      reducer_.reduceRow(
          upper, lower, std::size_t(part.width()),
          under.cells.get() + std::size_t(v / 2 + shift_y) * kEdge + std::size_t(part.left / 2 + shift_x));
    }
    under.dirty = under.dirty.united({part.left / 2 + shift_x, part.top / 2 + shift_y,
                                      (part.right + 1) / 2 + shift_x, (part.bottom + 1) / 2 + shift_y});
  }
  std::vector<Changed> next;
  next.reserve(coarse.size());
  for (auto& [key, made] : coarse) {
    const TileState after = stateOf(std::move(made.cells));
    patch.tiles[key] = {grid_.own(key), after};
    next.push_back({key, after.cells.get(), made.dirty});
  }
  return next;
}

Patch Canvas::take() {
  Patch patch;
  std::vector<Changed> changed;
  for (auto& [packed, written] : sheets_) {
    if (!written.wrote) continue;
    const TileKey key{0, int(packed & 0xffffffff), int(packed >> 32)};
    const TileState after = stateOf(std::move(written.wrote));
    patch.tiles[key] = {grid_.own(key), after};
    changed.push_back({key, after.cells.get(), written.dirty});
  }
  for (int level = 1; level < grid_.levels() && !changed.empty(); ++level) changed = reduced(changed, patch);
  patch.cells = touched_;
  sheets_.clear();
  last_ = nullptr;
  touched_ = {};
  return patch;
}

}  // namespace mapwright::picture
