// The colours of raster layers by cell byte: premultiplied 0xAARRGGBB. Pure. Source:
// docs/protocols/autoxing.md (costmaps: dark red obstacles, light red around them; incremental map: red
// obstacles, light blue free space; environment match: red where the world has changed).
#pragma once

#include <cstdint>
#include <vector>

#include "render/grid_renderer.h"
#include "render/tile_colors.h"

namespace mapwright::grids {
enum class CellCode : std::uint8_t;
class GridPyramid;
}  // namespace mapwright::grids

namespace mapwright::render {

/// From occupied to free, linear; unknown is transparent.
GridPalette wholeMapPalette(const MapColors& colors, grids::CellCode code);
/// The same between the incremental colours.
GridPalette incrementalPalette(const MapColors& colors, grids::CellCode code);
/// Values of a gray costmap. `background`: its most common byte, which means "no cost" (robots send both
/// polarities); the byte farthest from it is an obstacle.
GridPalette costmapPalette(std::uint8_t background);
/// Costs received as occupancy (grids::CellCode::Occupancy), as sent by costmap_2d: 0 free and unknown are
/// transparent, 1..98 inflated, 99 inscribed (the robot's centre must not be there), 100 lethal.
GridPalette occupancyCostPalette();
/// From bad (red) to good (green) by distance from `background`, which is transparent.
GridPalette matchPalette(std::uint8_t background);
/// Difference codes (sample_grid.h).
GridPalette differencePalette(bool dark);
/// A picture's own colours (not premultiplied); bytes beyond the list are transparent.
GridPalette ownPalette(const std::vector<std::uint32_t>& argb);

/// The most common byte, from a coarse sample of level 0.
std::uint8_t commonestByte(const grids::GridPyramid& cells);

}  // namespace mapwright::render
