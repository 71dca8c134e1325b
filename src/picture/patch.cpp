#include "picture/patch.h"

#include <set>

namespace mapwright::picture {

namespace {
constexpr std::size_t kTileBytes = 65'536;
}

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
  return held.size() * kTileBytes;
}

}  // namespace mapwright::picture
