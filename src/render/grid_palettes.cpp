#include "render/grid_palettes.h"

#include <algorithm>
#include <cstdlib>

#include "grids/grid_cells.h"
#include "grids/grid_pyramid.h"

namespace mapwright::render {
namespace {

std::uint32_t premultiplied(std::uint32_t argb) {
  const std::uint32_t alpha = argb >> 24;
  std::uint32_t out = alpha << 24;
  for (const int shift : {0, 8, 16}) {
    const std::uint32_t channel = argb >> shift & 255;
    out |= ((channel * alpha + 127) / 255) << shift;
  }
  return out;
}

std::uint32_t mixed(std::uint32_t from, std::uint32_t to, double part) {
  std::uint32_t out = 0;
  for (const int shift : {0, 8, 16, 24}) {
    const double a = from >> shift & 255, b = to >> shift & 255;
    out |= std::uint32_t(a + (b - a) * part + 0.5) << shift;
  }
  return out;
}

GridPalette ramp(grids::CellCode code, std::uint32_t occupied, std::uint32_t free) {
  const grids::CellMeaning& meaning = grids::meaningOf(code);
  GridPalette palette{};
  for (std::size_t byte = 0; byte < 256; ++byte) {
    if (meaning.known[byte])
      palette[byte] = 0xff000000 | mixed(occupied, free, meaning.intensity[byte] / 255.0);
  }
  return palette;
}

/// 0 at the background, 1 at the byte farthest from it.
double distanceFrom(std::uint8_t background, std::size_t byte) {
  return std::abs(int(byte) - int(background)) / double(std::max<int>(background, 255 - background));
}

}  // namespace

GridPalette wholeMapPalette(const MapColors& colors, grids::CellCode code) {
  return ramp(code, colors.occupied, colors.free);
}

GridPalette incrementalPalette(const MapColors& colors, grids::CellCode code) {
  return ramp(code, colors.incremental_occupied, colors.incremental_free);
}

GridPalette costmapPalette(std::uint8_t background) {
  constexpr std::uint32_t kObstacle = 0xd88b1016, kInflatedNear = 0xa0e8606a, kInflatedFar = 0x30f4a6ac;
  constexpr double kObstacleFrom = 0.97;
  GridPalette palette{};
  for (std::size_t byte = 0; byte < 256; ++byte) {
    const double cost = distanceFrom(background, byte);
    if (cost <= 0) continue;
    palette[byte] =
        premultiplied(cost >= kObstacleFrom ? kObstacle : mixed(kInflatedFar, kInflatedNear, cost));
  }
  return palette;
}

// Warmer and denser with the cost; the two forbidden values have colours of their own.
GridPalette occupancyCostPalette() {
  constexpr std::uint32_t kLethal = 0xe08b1016, kInscribed = 0xd0d14fa0;
  constexpr std::uint32_t kDear = 0xa8e0483c, kCheap = 0x40f4d06c;
  constexpr std::size_t kInscribedCost = 99, kLethalCost = 100;
  const grids::CellMeaning& meaning = grids::meaningOf(grids::CellCode::Occupancy);
  GridPalette palette{};
  for (std::size_t byte = 1; byte < 256; ++byte) {
    if (!meaning.known[byte]) continue;
    palette[byte] = premultiplied(byte >= kLethalCost      ? kLethal
                                  : byte == kInscribedCost ? kInscribed
                                                           : mixed(kCheap, kDear, double(byte - 1) / 97));
  }
  return palette;
}

GridPalette matchPalette(std::uint8_t background) {
  constexpr std::uint32_t kBad = 0xd0d1383d, kMiddle = 0xc0d98c00, kGood = 0xb02e9e5b;
  GridPalette palette{};
  for (std::size_t byte = 0; byte < 256; ++byte) {
    const double match = distanceFrom(background, byte);
    if (match <= 0) continue;
    palette[byte] =
        premultiplied(match < 0.5 ? mixed(kBad, kMiddle, match * 2) : mixed(kMiddle, kGood, match * 2 - 1));
  }
  return palette;
}

GridPalette differencePalette(bool dark) {
  GridPalette palette{};
  const auto set = [&](Difference what, std::uint32_t argb) {
    palette[std::size_t(what)] = premultiplied(argb);
  };
  set(Difference::SameFree, dark ? 0xff3c4653 : 0xfff4f6f8);
  set(Difference::SameOccupied, dark ? 0xff98a4b3 : 0xff39414c);
  set(Difference::Appeared, dark ? 0xffdd3749 : 0xffd93e48);
  set(Difference::Vanished, dark ? 0xff1f6feb : 0xff2377a4);
  set(Difference::OnlyFirst, dark ? 0xff2c4a73 : 0xffbcd4f7);
  set(Difference::OnlySecond, dark ? 0xff6b3034 : 0xfff3c6c8);
  return palette;
}

GridPalette ownPalette(const std::vector<std::uint32_t>& argb) {
  GridPalette palette{};
  for (std::size_t byte = 0; byte < std::min<std::size_t>(256, argb.size()); ++byte) {
    palette[byte] = premultiplied(argb[byte]);
  }
  return palette;
}

std::uint8_t commonestByte(const grids::GridPyramid& cells) {
  constexpr int kSamplesAnEdge = 200;
  std::array<int, 256> counts{};
  const int step_x = std::max(1, cells.width() / kSamplesAnEdge);
  const int step_y = std::max(1, cells.height() / kSamplesAnEdge);
  for (int row = 0; row < cells.height(); row += step_y) {
    for (int column = 0; column < cells.width(); column += step_x) ++counts[cells.at(column, row)];
  }
  return std::uint8_t(std::max_element(counts.begin(), counts.end()) - counts.begin());
}

}  // namespace mapwright::render
