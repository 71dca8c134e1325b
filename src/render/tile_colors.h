// Maps intensities and flags to colours. Pure; any thread.
#pragma once

#include <array>
#include <cstdint>

#include <QImage>

#include "render/compositor.h"

namespace mapwright::render {

/// How intensities are mapped to colours.
enum class ColorMode { Normal, Incremental, Active };

/// Plain RGB (0xffRRGGBB) of the palette.
struct MapColors {
  std::uint32_t unknown = 0xff778899, free = 0xffffffff, occupied = 0xff15181c;
  std::uint32_t incremental_free = 0xff8fb8f0, incremental_occupied = 0xffe04b4b;
  /// Unobserved pixels are transparent instead of `unknown`, because another layer is below the submaps.
  bool clear_unknown = false;
  bool operator==(const MapColors&) const = default;
};

/// The colour of every (flags, intensity): `unknown` if not observed, otherwise from occupied (0) to free
/// (255), linear. Incremental: kIncremental pixels use the incremental colours. Active: pixels without
/// kActive are dimmed to 35 % over `unknown`.
class ColorTable {
 public:
  ColorTable(const MapColors& colors, ColorMode mode);
  std::uint32_t at(std::uint8_t flags, std::uint8_t intensity) const {
    return table_[std::size_t((flags & 15) << 8 | intensity)];
  }
  /// An image of the whole composition: RGB32, or ARGB32_Premultiplied if unknown is transparent.
  QImage paint(const Composition& pixels) const;

 private:
  std::array<std::uint32_t, 16 * 256> table_;
  bool transparent_;
};

}  // namespace mapwright::render
