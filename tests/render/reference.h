// An independent double-precision composition, written straight from docs/protocols/cartographer-submaps.md,
// to hold the product against.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "cells/cell_texture.h"
#include "render/compositor.h"

namespace mapwright::testing {

/// A texture with its cells kept in plain sight.
struct PlainTexture {
  int width = 0, height = 0;
  double resolution_m = 0.05;
  std::vector<cells::CellPair> cells;
  render::PlacedTexture placed;
  double cos_yaw = 1, sin_yaw = 0;

  cells::CellPair at(int column, int row) const;  // (0,0) outside
};

/// Builds the real texture from the cells. Flags and id go into `placed`.
PlainTexture plainTexture(int width, int height, double resolution_m, std::vector<cells::CellPair> cells,
                          geometry::Pose2 pose, int index = 0, std::uint16_t flags = 0);

enum class Content {
  Folding,    // value and alpha exclude each other: rooms with walls, about two fifths known
  Pairs,      // anything goes, value + alpha up to 510
  Saturating  // adds much light and takes little
};
std::vector<cells::CellPair> randomCells(int width, int height, Content content, std::mt19937& random);

struct ReferencePixel {
  double intensity = 128;
  std::uint16_t flags = 0;
  bool flags_certain = true;      // not decided by a tap whose weight is next to nothing
  bool intensity_certain = true;  // not next to the jump between two nearest cells
};

/// k x k samples a pixel, every texture of `textures` in that order, all of one resolution.
std::vector<ReferencePixel> referenceComposition(const render::PixelGrid& grid,
                                                 const std::vector<PlainTexture>& textures);

/// 20 x 20 like cells around the world origin.
PlainTexture uniformTexture(cells::CellPair cell, int index = 0, std::uint16_t flags = 0,
                            double resolution_m = 1.0);

/// A grid whose middle is at `centre`.
render::PixelGrid gridAround(const Eigen::Vector2d& centre, double scale, double rotation, int width,
                             int height);
/// What the product makes of them, with a cache of its own.
render::Composition composeAll(const render::PixelGrid& grid, const std::vector<PlainTexture>& textures,
                               render::Quality quality = render::Quality::Exact,
                               render::Kernel kernel = render::Kernel::Best);
int pixelAt(const render::Composition& picture, int column, int row);
int flagsAt(const render::Composition& picture, int column, int row);

std::vector<render::PlacedTexture> placedOf(const std::vector<PlainTexture>& textures);

}  // namespace mapwright::testing
