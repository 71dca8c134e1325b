// The colours of disagreement and coverage: the same in the window and in pictures. Pure.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>

#include "agreement/survey.h"

namespace mapwright::agreement {

/// 0xAARRGGBB, not premultiplied.
using Argb = std::uint32_t;

/// The cells of a tile as indexes into a list of colours, row by row from the lowest y. Index 0 is
/// transparent: no submap saw the cell.
using Shades = std::array<std::uint8_t, std::size_t(kTileCells* kTileCells)>;

/// Gray ground, darker where a submap holds a cell occupied; contradictions from yellow to dark red, by the
/// number of them in the same square of 1 m, as a share of those in the worst one, on a logarithmic scale.
class DisagreementHeat {
 public:
  explicit DisagreementHeat(const Disagreement& found);
  static std::span<const Argb> colors();
  Shades shades(TileKey key, const Tile& tile) const;

 private:
  double cell_m_;
  std::map<Square, std::uint8_t> of_square_;
};

/// Seen once: hatched, for it proves nothing. From light to dark blue: 2 submaps, 3 to 4, 5 to 8, 9 to 16,
/// more.
class CoverageHeat {
 public:
  static std::span<const Argb> colors();
  static Shades shades(const Tile& tile);
};

}  // namespace mapwright::agreement
