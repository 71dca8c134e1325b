#include "picture/paint.h"

#include <algorithm>

namespace mapwright::picture {

namespace {
constexpr std::uint8_t kFreeGray = 255, kOccupiedGray = 0, kFreePercent = 0, kOccupiedPercent = 100;
constexpr int kOccupiedFrom = 50;
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
  constexpr int kTile = grids::GridPyramid::kTileEdge;
  for (int y = 0; y * kTile < cells.height() && !cancelled; ++y) {
    for (int x = 0; x * kTile < cells.width(); ++x) {
      const auto tile = cells.tile(0, x, y);
      if (!tile) continue;
      const int right = std::min(kTile, cells.width() - x * kTile),
                bottom = std::min(kTile, cells.height() - y * kTile);
      for (int v = 0; v < (tile->uniform ? 1 : bottom); ++v) {
        const std::uint8_t* const row = tile->cells.get() + std::size_t(v) * kTile;
        const std::uint8_t* const other =
            std::find_if(row, row + right, [&held](std::uint8_t byte) { return !held[byte]; });
        if (other != row + right) return *other;
      }
    }
  }
  return std::nullopt;
}

}  // namespace mapwright::picture
