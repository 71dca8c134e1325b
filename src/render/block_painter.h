// Places textures in the pixels of a grid (docs/protocols/cartographer-submaps.md, "Geometry"), and paints
// them into one square block of samples. Private to this room.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "render/compositor.h"
#include "render/kernel.h"
#include "render/tap_cells.h"

namespace mapwright::render {

/// A square of the infinite pixel raster: corner and edge in pixels. Edges below 1 are parts of a pixel.
struct PixelSquare {
  double column = 0, row = 0;
  double edge = 0;
};

/// Continuous cell coordinates of the centre of a square and its extent from there along each axis.
struct Footprint {
  double u = 0, v = 0;
  double reach_u = 0, reach_v = 0;
};

/// A texture seen from the pixels: cell coordinates (level 0, continuous, centre of the first cell at 0.5)
/// are affine in the absolute pixel coordinates (column, row) of the infinite raster.
struct Placement {
  const PlacedTexture* placed = nullptr;
  double u = 0, u_per_column = 0, u_per_row = 0;
  double v = 0, v_per_column = 0, v_per_row = 0;
  int width = 0, height = 0;  // cells of level 0
  double resolution_m = 0;
  bool nearest = false;
  int level = 0;  // that is sampled
  // The rows of pixels that it can affect, absolute, including bilinear fade.
  double first_row = 0, last_row = 0;

  Footprint footprintOf(const PixelSquare& square) const;
  /// Whether any sample of the square may differ from (0, 0). May be true unnecessarily, never false wrongly.
  bool touches(const PixelSquare& square) const;
};

/// The placements of all drawable textures, in the given order. Textures without cells or with non-finite
/// numbers are left out.
std::vector<Placement> placeTextures(const PixelGrid& grid, std::span<const PlacedTexture> textures,
                                     Quality quality);

/// Samples a square of pixels `samples` x `samples` times. Keeps the dense levels it uses up to a limit, so
/// that neighbouring blocks do not ask the cache again. One per composition, one thread.
class BlockPainter {
 public:
  BlockPainter(DenseCache& cache, Kernel kernel, std::size_t placements);

  /// Fills the first `samples` rows and columns of block(). False if the area is empty: then the block is not
  /// written. `samples` <= kBlockEdge; candidates are indexes into `placements`, in painting order.
  bool paint(const PixelSquare& square, int samples, std::span<const Placement> placements,
             std::span<const std::uint32_t> candidates);
  const SampleBlock& block() const { return *block_; }

 private:
  struct Sampling;
  const TapCells& cellsOf(const Placement& placement, std::size_t index);
  void paintTexture(const PixelSquare& square, int samples, const Placement& placement, std::size_t index);
  void paintCoarse(const Sampling& sampling, const TapCells& cells, const Placement& placement);
  void paintFine(const Sampling& sampling, const TapCells& cells, const Placement& placement);
  void begin(int samples);

  DenseCache& cache_;
  void (*kernel_)(const BlockPass&, SampleBlock&);
  std::unique_ptr<SampleBlock> block_ = std::make_unique<SampleBlock>();
  bool begun_ = false;
  std::vector<std::shared_ptr<const TapCells>> held_;  // by placement
  std::vector<std::size_t> held_indexes_;
  std::size_t held_bytes_ = 0;
};

}  // namespace mapwright::render
