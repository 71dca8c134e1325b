// Which shade of gray stands for which cell, so that whoever reads the picture as its map.yaml says gets that
// cell. Pure. Source: ROS map_server / nav2 map_io (grids::cellFromPixel).
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "grids/grid_cells.h"

namespace mapwright::grids {

struct PictureShades {
  std::array<std::uint8_t, 256> cell_of{};                  // of an opaque pixel, by its gray
  std::array<std::optional<std::uint8_t>, 256> shade_of{};  // nullopt: no opaque gray is that cell
  /// A transparent pixel is this cell.
  std::uint8_t transparent = 0;
  bool canBe(std::uint8_t cell, bool with_alpha) const {
    return shade_of[cell].has_value() || (with_alpha && cell == transparent);
  }
};
/// map_saver's shades (254 free, 0 occupied, 205 unknown) where they read so, else one that does.
PictureShades shadesFor(const map::CellReading& reading);

}  // namespace mapwright::grids
