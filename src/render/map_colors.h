// The palette of the map raster.
#pragma once

#include <cstdint>

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

}  // namespace mapwright::render
