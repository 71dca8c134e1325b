// Maps intensities and flags to colours. Pure; any thread.
#pragma once

#include <array>
#include <cstdint>

#include <QImage>

#include "render/compositor.h"
#include "render/map_colors.h"

namespace mapwright::render {

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
