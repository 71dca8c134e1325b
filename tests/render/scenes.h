// Rooms full of submaps for the tests of the tile renderer.
#pragma once

#include <cstdint>
#include <vector>

#include "cells/cell_texture.h"
#include "geometry/view_transform.h"
#include "render/compositor.h"

namespace mapwright::testing {

/// `count` submaps of 100 x 80 cells of 5 cm on a field of `across_m` metres around the origin, at any angle,
/// always the same.
std::vector<render::PlacedTexture> field(int count, double across_m, unsigned seed = 1);

/// One square texture of `edge_m` metres, all cells alike, its middle at (x, y).
render::PlacedTexture square(int index, double x, double y, double edge_m, cells::CellPair cell,
                             std::uint16_t flags = 0);

geometry::ViewTransform viewAt(double x, double y, double scale, int width, int height, double rotation = 0);
render::PixelGrid gridOf(const geometry::ViewTransform& view);

}  // namespace mapwright::testing
