// What the bytes of an occupancy grid mean. Pure values, any thread.
// Source: ROS map_server / nav2 map_io (readings), nav_msgs/OccupancyGrid (cells).
#pragma once

#include <array>
#include <cstdint>

#include "map/catalogue.h"

namespace mapwright::raster {

/// How the one byte of a cell is coded.
enum class CellCode : std::uint8_t {
  Gray,       // a gray level: 0 occupied .. 255 free; 112..143 and 205 = unknown
  Occupancy,  // nav_msgs/OccupancyGrid: 0..100 percent, as int8 (-1 = 255 = unknown; 101..127 count as 100,
              // other negative ones as unknown; a "raw" map may hold any of them)
};

/// Gray pictures: the byte that stands for a transparent pixel. An opaque pixel of this very gray is unknown
/// all the same.
inline constexpr std::uint8_t kTransparentGray = 128;
inline constexpr std::uint8_t kUnknownOccupancy = 255;

/// Tables over the 256 bytes of a code.
struct CellMeaning {
  std::array<bool, 256> known{};
  std::array<std::uint8_t, 256> intensity{};  // 0 occupied .. 255 free, linear; 128 where unknown
  std::array<std::int8_t, 256> occupancy{};   // -1 unknown, 0..100 percent (rounded)
  std::array<std::uint8_t, 256> rank{};       // unknown 0, free 1, .., occupied 255: the highest wins
};
const CellMeaning& meaningOf(CellCode code);

/// The code that a reading gives: Picture -> Gray, the others -> Occupancy.
CellCode codeOf(const map::CellReading& reading);

/// The cell byte of one pixel. `shade_sum` is the sum of the colour channels (each 0..1), `channels` their
/// number (1 or 3), `alpha` 0..1 (1 when the picture has none; `has_alpha` says so). Exactly as map_server:
/// trinary averages alpha in with the colours when there is one, scale takes anything transparent as unknown,
/// raw ignores alpha. Picture: alpha < 0.5 is kTransparentGray, else the gray (luminance of colours).
std::uint8_t cellFromPixel(const map::CellReading& reading, double shade_sum, int channels, double alpha,
                           bool has_alpha);

}  // namespace mapwright::raster
