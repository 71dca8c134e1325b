// Paints placed textures into one square block of samples. Private to this room.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "render/kernel.h"
#include "render/placement.h"

namespace mapwright::render {

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
