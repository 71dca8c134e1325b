// The meaning of the bytes of an occupancy grid. Pure values, any thread. Source: ROS map_server / nav2
// map_io (readings), nav_msgs/OccupancyGrid (cells).
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "map/catalogue.h"

namespace mapwright::grids {

/// How the byte of a cell is coded.
enum class CellCode : std::uint8_t {
  Gray,        // a gray level: 0 occupied .. 255 free; 112..143 and 205 = unknown
  Occupancy,   // nav_msgs/OccupancyGrid: 0..100 percent, as int8 (-1 = 255 = unknown; 101..127 count as 100,
               // other negative ones as unknown; a "raw" map may hold any of them)
  ShadedGray,  // like Gray, but 205 is an ordinary gray: pictures of many gray levels with unknown areas
  ClearGray,   // only 128 = unknown: pictures of all gray levels with transparent pixels
  FullGray,    // every byte is a gray level
};
inline constexpr int kCellCodes = 5;

inline constexpr bool isGray(CellCode code) { return code != CellCode::Occupancy; }

/// Gray pictures: the byte for a transparent pixel. Except in a FullGray picture, an opaque pixel of this
/// gray is unknown as well.
inline constexpr std::uint8_t kTransparentGray = 128;
inline constexpr std::uint8_t kUnknownOccupancy = 255;
/// The byte for cells that do not exist.
inline constexpr std::uint8_t unknownByte(CellCode code) {
  return isGray(code) ? kTransparentGray : kUnknownOccupancy;
}

/// The gray levels that a code treats as unknown: a range of them, and 205.
struct UnknownGrays {
  int from = 0, to = -1;  // inclusive; empty if `to` is smaller
  bool saver = false;     // 205, map_saver's
};
inline constexpr UnknownGrays unknownGrays(CellCode code) {
  switch (code) {
    case CellCode::ShadedGray:
      return {112, 143, false};
    case CellCode::ClearGray:
      return {kTransparentGray, kTransparentGray, false};
    case CellCode::FullGray:
      return {};
    default:
      return {112, 143, true};
  }
}

/// Tables over the 256 bytes of a code.
struct CellMeaning {
  std::array<bool, 256> known{};
  std::array<std::uint8_t, 256> intensity{};  // 0 occupied .. 255 free, linear; 128 where unknown
  std::array<std::int8_t, 256> occupancy{};   // -1 unknown, 0..100 percent (rounded)
  std::array<std::uint8_t, 256> rank{};       // unknown 0, free 1, .., occupied 255: the highest wins
};
const CellMeaning& meaningOf(CellCode code);

/// The code of a reading: Picture -> a gray one (GrayShades decides which), the others -> Occupancy.
CellCode codeOf(const map::CellReading& reading);

/// The cell byte of one pixel. `shade_sum` is the sum of the colour channels (each 0..1), `channels` their
/// number (1 or 3), `alpha` 0..1 (1 if the picture has none; see `has_alpha`). Exactly as map_server: trinary
/// includes alpha in the average if there is one, scale treats anything transparent as unknown, raw ignores
/// alpha. Picture: alpha < 0.5 is kTransparentGray, otherwise the gray (luminance of colours).
std::uint8_t cellFromPixel(const map::CellReading& reading, double shade_sum, int channels, double alpha,
                           bool has_alpha);

/// Which gray level to write for a cell, so that a reader following the map.yaml gets that cell.
struct PictureShades {
  std::array<std::uint8_t, 256> cell_of{};                  // of an opaque pixel, by its gray level
  std::array<std::optional<std::uint8_t>, 256> shade_of{};  // nullopt: no opaque gray gives that cell
  /// A transparent pixel is this cell.
  std::uint8_t transparent = 0;
  bool canBe(std::uint8_t cell, bool with_alpha) const {
    return shade_of[cell].has_value() || (with_alpha && cell == transparent);
  }
};
/// map_saver's gray levels (254 free, 0 occupied, 205 unknown) if they are read that way, otherwise suitable
/// ones.
PictureShades shadesFor(const map::CellReading& reading);

}  // namespace mapwright::grids
