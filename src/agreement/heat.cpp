#include "agreement/heat.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace mapwright::agreement {
namespace {

// Shades of disagreement; the rest is the ramp.
constexpr std::uint8_t kGround = 1, kHeld = 2, kRamp = 3;
constexpr std::size_t kRampSteps = 32;
// Shades of coverage; the rest are steps of doubling.
constexpr std::uint8_t kOnce = 1, kOnceLine = 2, kTwice = 3;

std::array<Argb, kRamp + kRampSteps> disagreementColors() {
  constexpr std::array<std::array<double, 3>, 4> kStops{
      {{255, 214, 64}, {255, 140, 26}, {230, 50, 30}, {140, 0, 20}}};
  std::array<Argb, kRamp + kRampSteps> colors{0, 0xffe6e6e6, 0xff787878};
  for (std::size_t step = 0; step < kRampSteps; ++step) {
    const double at = double(step) / (kRampSteps - 1) * (kStops.size() - 1);
    const std::size_t below = std::min(std::size_t(at), kStops.size() - 2);
    Argb color = 0xff;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const double from = kStops[below][channel], to = kStops[below + 1][channel];
      color = color << 8 | Argb(std::lround(from + (to - from) * (at - double(below))));
    }
    colors[kRamp + step] = color;
  }
  return colors;
}

template <typename ShadeOf>
Shades shaded(const Tile& tile, ShadeOf shadeOf) {
  Shades shades;
  for (int row = 0; row < kTileCells; ++row) {
    for (int column = 0; column < kTileCells; ++column) {
      shades[std::size_t(row * kTileCells + column)] =
          tile.seenBy(column, row) == 0 ? std::uint8_t(0) : shadeOf(column, row);
    }
  }
  return shades;
}

}  // namespace

DisagreementHeat::DisagreementHeat(const Disagreement& found) : cell_m_(found.cell_m) {
  const double most = found.places.empty() ? 1 : double(found.places.front().cells);
  for (const Place& place : found.places) {
    const double share = most <= 1 ? 1 : std::log(double(place.cells)) / std::log(most);
    of_square_[squareAt(place.x, place.y)] = std::uint8_t(kRamp + std::lround(share * (kRampSteps - 1)));
  }
}

std::span<const Argb> DisagreementHeat::colors() {
  static const auto colors = disagreementColors();
  return colors;
}

Shades DisagreementHeat::shades(TileKey key, const Tile& tile) const {
  return shaded(tile, [&](int column, int row) {
    if (!tile.isContradicted(column, row)) return tile.isOccupied(column, row) ? kHeld : kGround;
    const Eigen::Vector2d centre = centreOf(key, column, row, cell_m_);
    const auto found = of_square_.find(squareAt(centre.x(), centre.y()));
    return found == of_square_.end() ? kRamp : found->second;
  });
}

std::span<const Argb> CoverageHeat::colors() {
  static constexpr std::array<Argb, 8> kColors{0,          0xffecc77a, 0xff8a5a00, 0xffdceaf7,
                                               0xff93c6e6, 0xff3f92cc, 0xff1a5fa8, 0xff082a63};
  return kColors;
}

Shades CoverageHeat::shades(const Tile& tile) {
  // A tile is a whole number of hatches wide: they run on across tiles.
  static_assert(kTileCells % 4 == 0);
  return shaded(tile, [&tile](int column, int row) {
    const unsigned seen_by = tile.seenBy(column, row);
    if (seen_by == 1) return (column + row) % 4 == 0 ? kOnceLine : kOnce;
    // 2, 3 to 4, 5 to 8, ...
    return std::uint8_t(
        std::min(std::size_t(kTwice) + std::size_t(std::bit_width(seen_by - 1)) - 1, colors().size() - 1));
  });
}

}  // namespace mapwright::agreement
