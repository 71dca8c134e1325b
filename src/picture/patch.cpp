#include "picture/patch.h"

#include <set>

namespace mapwright::picture {

namespace {}

void Patch::append(const Patch& later) {
  for (const auto& [place, change] : later.tiles) {
    const auto [found, added] = tiles.try_emplace(place, change);
    if (!added) found->second.after = change.after;
  }
  cells = cells.united(later.cells);
}

std::size_t Patch::bytes() const {
  std::set<const std::uint8_t*> held;
  for (const auto& [place, change] : tiles) {
    for (const TileState* state : {&change.before, &change.after}) {
      if (state->cells) held.insert(state->cells.get());
    }
  }
  return held.size() * Canvas::kTileCells;
}

void PatchMemory::add(const Patch& patch) {
  for (const auto& [place, change] : patch.tiles) {
    for (const TileState* state : {&change.before, &change.after}) {
      if (state->cells) ++held_[state->cells.get()];
    }
  }
}

void PatchMemory::remove(const Patch& patch) {
  for (const auto& [place, change] : patch.tiles) {
    for (const TileState* state : {&change.before, &change.after}) {
      if (!state->cells) continue;
      const auto found = held_.find(state->cells.get());
      if (found != held_.end() && --found->second == 0) held_.erase(found);
    }
  }
}

std::size_t PatchMemory::bytes() const { return held_.size() * Canvas::kTileCells; }

}  // namespace mapwright::picture
