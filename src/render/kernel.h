// The inner loops of the compositor: one texture painted over one small block of samples.
// Private to this room. All variants run the same integer and float operations per sample and so give the
// same bytes. Source: docs/protocols/cartographer-submaps.md, "Composition".
#pragma once

#include <cstdint>

#include "cells/cell_texture.h"

namespace mapwright::render {

/// Fraction bits of texture coordinates inside a block. A block spans less than 2048 cells, and after 64
/// steps a rounded increment is off by at most 1/8000 of a cell.
inline constexpr int kCoordinateBits = 20;
/// Bits of the bilinear weights; the four weights of a sample add up to exactly 2^kWeightBits.
inline constexpr int kWeightBits = 14;
/// Largest edge of a block in samples, and the distance between the rows of its accumulators.
inline constexpr int kBlockEdge = 64;

/// The state of a block of samples. Fits into the first-level cache.
struct SampleBlock {
  alignas(32) float intensity[kBlockEdge * kBlockEdge];
  alignas(32) std::int32_t flags[kBlockEdge * kBlockEdge];
};

/// One texture over samples [first_column, first_column + columns) x [first_row, first_row + rows) of a
/// block. first_column and columns are multiples of 8 (extra samples are scratch).
struct BlockPass {
  const std::uint8_t* cells = nullptr;  // the cell of TapCells::taps that relative coordinates refer to
  int stride = 0;                       // cells
  cells::CellLayout layout = cells::CellLayout::Folded;
  // Tap coordinates of sample (0,0) of the block relative to `cells` and their increments, kCoordinateBits
  // fixed point.
  std::int32_t u = 0, v = 0;
  std::int32_t u_per_column = 0, v_per_column = 0;
  std::int32_t u_per_row = 0, v_per_row = 0;
  // Coordinates are clamped to these: their ends read the zero frame. Not needed if `inside`.
  std::int32_t u_low = 0, u_high = 0, v_low = 0, v_high = 0;
  bool inside = false;   // no sample of the pass needs clamping
  bool nearest = false;  // one tap instead of four
  std::int32_t flags = 0;
  int first_column = 0, first_row = 0, columns = 0, rows = 0;
};

void paintPortable(const BlockPass& pass, SampleBlock& block);
void paintAvx2(const BlockPass& pass, SampleBlock& block);  // only if kernelAvailable(Kernel::Avx2)
bool avx2Compiled();

}  // namespace mapwright::render
