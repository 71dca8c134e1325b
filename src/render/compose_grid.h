// Composes all submaps into one grid of cells, strip by strip, for export and comparison.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <span>

#include <tl/expected.hpp>

#include "fault/fault.h"
#include "grids/grid_pyramid.h"
#include "map/grid_reference.h"
#include "render/compositor.h"

namespace mapwright::render {

struct ComposedGrid {
  std::shared_ptr<const grids::GridPyramid> cells;  // code Occupancy: percent
  map::GridReference reference;                     // unturned
};

/// Composes `textures` (ascending ids) exactly at `resolution_m`, over their whole area. Memory: one strip of
/// 256 rows and the compressed grid. `proceed` gets the share done (0..1) and cancels by returning false. Any
/// thread; one core plus those of `means`.
tl::expected<ComposedGrid, Fault> composeGrid(std::span<const PlacedTexture> textures, double resolution_m,
                                              DenseCache& cache,
                                              const std::function<bool(double done)>& proceed = {},
                                              const grids::Resources& resources = {});

}  // namespace mapwright::render
