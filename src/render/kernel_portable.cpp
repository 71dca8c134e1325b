#include <algorithm>

#include "render/kernel.h"

namespace mapwright::render {
namespace {

constexpr std::int32_t kOne = 1 << kWeightBits;
constexpr int kFractionShift = kCoordinateBits - kWeightBits;
constexpr int kChunk = 64;

// Weighted sums of one row, so that the arithmetic after the scattered loads is a plain loop that can be
// vectorised.
struct RowSums {
  alignas(32) std::int32_t value[kChunk];
  alignas(32) std::int32_t alpha[kChunk];
};

struct Weights {
  std::int32_t w00, w01, w10, w11;
};

Weights weightsAt(std::int32_t u, std::int32_t v, std::int32_t fraction_mask) {
  const std::int32_t fu = (u >> kFractionShift) & fraction_mask;
  const std::int32_t fv = (v >> kFractionShift) & fraction_mask;
  const std::int32_t w11 = (fu * (fv << 1) + (1 << 14)) >> 15;
  const std::int32_t w10 = fv - w11;
  return {kOne - fu - w10, fu - w11, w10, w11};
}

void sumFolded(const std::uint8_t* cell, const Weights& w, std::int32_t& value, std::int32_t& alpha) {
  const auto* taps = reinterpret_cast<const std::int8_t*>(cell);
  const std::int32_t p00 = w.w00 * taps[0], p10 = w.w10 * taps[1];
  const std::int32_t p01 = w.w01 * taps[2], p11 = w.w11 * taps[3];
  value = std::max(p00, 0) + std::max(p01, 0) + std::max(p10, 0) + std::max(p11, 0);
  alpha = std::min(p00, 0) + std::min(p01, 0) + std::min(p10, 0) + std::min(p11, 0);
}

void sumPairs(const std::uint8_t* cell, int stride, const Weights& w, std::int32_t& value,
              std::int32_t& alpha) {
  const std::uint8_t* bottom = cell + 2 * std::ptrdiff_t(stride);
  value = w.w00 * cell[0] + w.w01 * cell[2] + w.w10 * bottom[0] + w.w11 * bottom[2];
  alpha = -(w.w00 * cell[1] + w.w01 * cell[3] + w.w10 * bottom[1] + w.w11 * bottom[3]);
}

template <bool kPairs>
void gatherRow(const BlockPass& pass, std::int32_t u, std::int32_t v, RowSums& sums) {
  const std::int32_t mask = pass.nearest ? 0 : kOne - 1;
  for (int i = 0; i < pass.columns; ++i, u += pass.u_per_column, v += pass.v_per_column) {
    const std::int32_t cu = std::clamp(u, pass.u_low, pass.u_high);
    const std::int32_t cv = std::clamp(v, pass.v_low, pass.v_high);
    const std::ptrdiff_t cell = std::ptrdiff_t(cv >> kCoordinateBits) * pass.stride + (cu >> kCoordinateBits);
    const Weights weights = weightsAt(cu, cv, mask);
    if constexpr (kPairs) {
      sumPairs(pass.cells + 2 * cell, pass.stride, weights, sums.value[i], sums.alpha[i]);
    } else {
      sumFolded(pass.cells + 2 * cell, weights, sums.value[i], sums.alpha[i]);
    }
  }
}

void blendRow(const RowSums& sums, int count, std::int32_t new_flags, float* intensity, std::int32_t* flags) {
  constexpr float kValueUnit = 1.0F / float(kOne);
  constexpr float kAlphaUnit = 1.0F / (255.0F * float(kOne));
  for (int i = 0; i < count; ++i) {
    const float value = float(sums.value[i]) * kValueUnit;
    const float minus_alpha = float(sums.alpha[i]) * kAlphaUnit;
    const float below = intensity[i];
    const float kept = below + below * minus_alpha;
    intensity[i] = std::min(kept + value, 255.0F);
    flags[i] = (sums.value[i] | sums.alpha[i]) != 0 ? new_flags : flags[i];
  }
}

}  // namespace

void paintPortable(const BlockPass& pass, SampleBlock& block) {
  RowSums sums;
  for (int j = 0; j < pass.rows; ++j) {
    const int row = pass.first_row + j;
    const std::int32_t u = pass.u + row * pass.u_per_row + pass.first_column * pass.u_per_column;
    const std::int32_t v = pass.v + row * pass.v_per_row + pass.first_column * pass.v_per_column;
    if (pass.layout == cells::CellLayout::Pairs) {
      gatherRow<true>(pass, u, v, sums);
    } else {
      gatherRow<false>(pass, u, v, sums);
    }
    const int at = row * kBlockEdge + pass.first_column;
    blendRow(sums, pass.columns, pass.flags, block.intensity + at, block.flags + at);
  }
}

}  // namespace mapwright::render
