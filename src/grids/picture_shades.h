// Which gray level to write for a cell, so that a reader following the map.yaml gets that cell. Pure. Source:
// ROS map_server / nav2 map_io (grids::cellFromPixel).
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "grids/grid_cells.h"

namespace mapwright::grids {

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
