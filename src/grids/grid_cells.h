// What the bytes of an occupancy grid mean. Pure values, any thread.
// Source: ROS map_server / nav2 map_io (readings), nav_msgs/OccupancyGrid (cells).
#pragma once

#include <array>
#include <cstdint>

#include "map/catalogue.h"

namespace mapwright::grids {

/// How the one byte of a cell is coded.
enum class CellCode : std::uint8_t {
  Gray,        // a gray level: 0 occupied .. 255 free; 112..143 and 205 = unknown
  Occupancy,   // nav_msgs/OccupancyGrid: 0..100 percent, as int8 (-1 = 255 = unknown; 101..127 count as 100,
               // other negative ones as unknown; a "raw" map may hold any of them)
  ShadedGray,  // as Gray, but 205 is a gray like any other: pictures of many shades with unknown ground
  ClearGray,   // only 128 = unknown: pictures of all shades with transparent pixels
  FullGray,    // every byte is a gray: pictures of all shades
};
inline constexpr int kCellCodes = 5;

inline constexpr bool isGray(CellCode code) { return code != CellCode::Occupancy; }

/// Gray pictures: the byte that stands for a transparent pixel. An opaque pixel of this very gray is unknown
/// all the same, but in a FullGray picture.
inline constexpr std::uint8_t kTransparentGray = 128;
inline constexpr std::uint8_t kUnknownOccupancy = 255;
/// What stands for cells that are not there.
inline constexpr std::uint8_t unknownByte(CellCode code) {
  return isGray(code) ? kTransparentGray : kUnknownOccupancy;
}

/// The gray levels that a code takes for unknown: a band of them, and 205.
struct UnknownGrays {
  int from = 0, to = -1;  // inclusive; empty where `to` is less
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

/// The code that a reading gives: Picture -> a gray one (which, the picture itself says: gray_shades.h), the
/// others -> Occupancy.
CellCode codeOf(const map::CellReading& reading);

/// The cell byte of one pixel. `shade_sum` is the sum of the colour channels (each 0..1), `channels` their
/// number (1 or 3), `alpha` 0..1 (1 when the picture has none; `has_alpha` says so). Exactly as map_server:
/// trinary averages alpha in with the colours when there is one, scale takes anything transparent as unknown,
/// raw ignores alpha. Picture: alpha < 0.5 is kTransparentGray, else the gray (luminance of colours).
std::uint8_t cellFromPixel(const map::CellReading& reading, double shade_sum, int channels, double alpha,
                           bool has_alpha);

}  // namespace mapwright::grids
