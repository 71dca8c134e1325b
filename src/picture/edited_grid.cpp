#include "picture/edited_grid.h"

#include <set>

namespace mapwright::picture {
namespace {

/// Calls visit(cells) for each tile that a patch holds.
template <typename Visit>
void eachHeld(const Patch& patch, Visit visit) {
  for (const auto& [key, change] : patch.tiles) {
    for (const TileState* state : {&change.before, &change.after}) {
      if (state->cells) visit(state->cells.get());
    }
  }
}

}  // namespace

void Patch::append(const Patch& later) {
  for (const auto& [key, change] : later.tiles) {
    const auto [found, added] = tiles.try_emplace(key, change);
    if (!added) found->second.after = change.after;
  }
  cells = cells.united(later.cells);
}

std::size_t Patch::bytes() const {
  std::set<const std::uint8_t*> held;
  eachHeld(*this, [&](const std::uint8_t* cells) { held.insert(cells); });
  return held.size() * kTileCells;
}

void PatchMemory::add(const Patch& patch) {
  eachHeld(patch, [this](const std::uint8_t* cells) { ++held_[cells]; });
}

void PatchMemory::remove(const Patch& patch) {
  eachHeld(patch, [this](const std::uint8_t* cells) {
    const auto found = held_.find(cells);
    if (found != held_.end() && --found->second == 0) held_.erase(found);
  });
}

std::size_t PatchMemory::bytes() const { return held_.size() * kTileCells; }

std::size_t EditedGrid::TileKeyHash::operator()(const TileKey& key) const noexcept {
  const std::uint64_t mixed =
      std::uint64_t(key.level) << 48 ^ std::uint64_t(unsigned(key.y)) << 24 ^ unsigned(key.x);
  return std::size_t(mixed * 0x9e3779b97f4a7c15u >> 16);
}

EditedGrid::EditedGrid(std::shared_ptr<const grids::GridPyramid> base) : base_(std::move(base)) {}

EditedGrid::EditedGrid(std::shared_ptr<const grids::GridPyramid> base, Tiles tiles)
    : base_(std::move(base)), tiles_(std::move(tiles)) {}

std::optional<grids::GridTile> EditedGrid::tile(int level, int tile_x, int tile_y) const {
  const TileState state = own({level, tile_x, tile_y});
  if (state.cells) return grids::GridTile{state.cells, state.uniform, false};
  return base_->tile(level, tile_x, tile_y);
}

std::size_t EditedGrid::bytes() const {
  const std::lock_guard lock(mutex_);
  return base_->bytes() + tiles_.size() * kTileCells;
}

std::shared_ptr<EditedGrid> EditedGrid::snapshot() const {
  const std::lock_guard lock(mutex_);
  return std::shared_ptr<EditedGrid>(new EditedGrid(base_, tiles_));
}

TileState EditedGrid::own(const TileKey& key) const {
  const std::lock_guard lock(mutex_);
  const auto found = tiles_.find(key);
  return found == tiles_.end() ? TileState{} : found->second;
}

std::vector<TileKey> EditedGrid::changedTiles() const {
  const std::lock_guard lock(mutex_);
  std::vector<TileKey> keys;
  for (const auto& [key, state] : tiles_) {
    if (key.level == 0) keys.push_back(key);
  }
  return keys;
}

void EditedGrid::exchange(const Patch& patch, TileState TileChange::*side) {
  const std::lock_guard lock(mutex_);
  for (const auto& [key, change] : patch.tiles) {
    const TileState& state = change.*side;
    if (state.cells) {
      tiles_[key] = state;
    } else {
      tiles_.erase(key);
    }
  }
  ++revision_;
}

void EditedGrid::apply(const Patch& patch) { exchange(patch, &TileChange::after); }
void EditedGrid::revert(const Patch& patch) { exchange(patch, &TileChange::before); }

}  // namespace mapwright::picture
