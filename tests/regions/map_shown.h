// What a map by regions shows, next to the ground that it is of.
#pragma once

#include "fake_dispatch.h"
#include "regions/map_regions.h"
#include "regions/region_sheet.h"

namespace mapwright::regions {

/// The cell at a place; kNotFetched where none came.
inline std::uint8_t shown(const MapRegions& regions, const Eigen::Vector2d& world) {
  for (const auto& sheet : regions.sheets()) {
    const Eigen::Vector2d cell = sheet->reference().cellFromWorld(world);
    if (!(cell.x() >= 0 && cell.y() >= 0 && cell.x() < sheet->width() && cell.y() < sheet->height()))
      continue;
    const auto tile = sheet->tile(0, int(cell.x()) / 256, int(cell.y()) / 256);
    if (!tile) continue;
    const std::uint8_t byte =
        tile->cells.get()[std::size_t(int(cell.y()) % 256) * 256 + std::size_t(int(cell.x()) % 256)];
    if (byte != kNotFetched) return byte;
  }
  return kNotFetched;
}

/// What the ground has there; kNotFetched beside it.
inline std::uint8_t truth(const FakeGround& ground, const Eigen::Vector2d& world) {
  const Eigen::Vector2d cell = ground.origin.inverse().apply(world) / ground.resolution_m;
  if (!(cell.x() >= 0 && cell.y() >= 0 && cell.x() < ground.width && cell.y() < ground.height))
    return kNotFetched;
  return std::uint8_t(ground.cell(int(cell.x()), int(cell.y())));
}

/// Places of the view that show something else than the ground has.
inline int wrongIn(const MapRegions& regions, const FakeGround& ground, const geometry::WorldRect& view) {
  int wrong = 0;
  for (double x = view.min_x + 0.013; x < view.max_x; x += 0.37) {
    for (double y = view.min_y + 0.017; y < view.max_y; y += 0.41)
      wrong += shown(regions, {x, y}) != truth(ground, {x, y});
  }
  return wrong;
}

}  // namespace mapwright::regions
