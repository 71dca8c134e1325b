// Compiled with -mavx2 and without FMA, so that every rounding is that of kernel_portable.cpp. Only
// intrinsics and plain loops here: a library template instantiated in this file could leak AVX2 code into
// machines without it.
#include "render/kernel.h"

#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace mapwright::render {

#if defined(__AVX2__)
namespace {

constexpr int kFractionShift = kCoordinateBits - kWeightBits;

// Four taps of one sample. Not with the gather instruction: with the microcode against its data sampling flaw
// it costs several times as much as plain loads, and it is never much faster (measured in bench_compositor).
inline std::uint32_t loadTaps(const std::uint8_t* at) {
  std::uint32_t taps;
  __builtin_memcpy(&taps, at, sizeof taps);
  return taps;
}

struct Row {
  alignas(32) std::int32_t cell[kBlockEdge];  // relative to BlockPass::cells
  alignas(32) std::uint32_t
      weights[2 * kBlockEdge];  // top (left, right), bottom (left, right), 8 samples each in turn
  alignas(
      32) std::uint32_t taps[2 * kBlockEdge];  // folded: one word a sample; pairs: 8 top, 8 bottom in turn
};

struct Sums {
  __m256i value, minus_alpha;
};

// 16-bit pairs (left, right) weighted and added per lane, both rows.
inline __m256i weigh(__m256i top, __m256i bottom, __m256i top_weights, __m256i bottom_weights) {
  return _mm256_add_epi32(_mm256_madd_epi16(top, top_weights), _mm256_madd_epi16(bottom, bottom_weights));
}

inline __m256i loadLanes(const void* at) { return _mm256_load_si256(static_cast<const __m256i*>(at)); }
inline void storeLanes(void* at, __m256i lanes) { _mm256_store_si256(static_cast<__m256i*>(at), lanes); }

template <bool kPairs>
inline Sums sumTaps(const Row& row, int i) {
  const __m256i zero = _mm256_setzero_si256();
  const __m256i top_weights = loadLanes(row.weights + 2 * i),
                bottom_weights = loadLanes(row.weights + 2 * i + 8);
  if constexpr (kPairs) {
    // Bytes value0 alpha0 value1 alpha1: the even bytes are the values, the odd ones the alphas.
    const __m256i top = loadLanes(row.taps + 2 * i), bottom = loadLanes(row.taps + 2 * i + 8);
    const __m256i low = _mm256_set1_epi16(0x00ff);
    const __m256i value =
        weigh(_mm256_and_si256(top, low), _mm256_and_si256(bottom, low), top_weights, bottom_weights);
    const __m256i alpha =
        weigh(_mm256_srli_epi16(top, 8), _mm256_srli_epi16(bottom, 8), top_weights, bottom_weights);
    return {value, _mm256_sub_epi32(zero, alpha)};
  } else {
    // Bytes top0 bottom0 top1 bottom1, signed.
    const __m256i taps = loadLanes(row.taps + i);
    const __m256i top = _mm256_srai_epi16(_mm256_slli_epi16(taps, 8), 8);
    const __m256i bottom = _mm256_srai_epi16(taps, 8);
    return {weigh(_mm256_max_epi16(top, zero), _mm256_max_epi16(bottom, zero), top_weights, bottom_weights),
            weigh(_mm256_min_epi16(top, zero), _mm256_min_epi16(bottom, zero), top_weights, bottom_weights)};
  }
}

// Which cells the samples of a row read, and the weights of their taps.
template <bool kInside>
inline void locate(const BlockPass& pass, std::int32_t u_start, std::int32_t v_start, Row& row) {
  const __m256i lanes = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
  const __m256i u_step = _mm256_set1_epi32(8 * pass.u_per_column);
  const __m256i v_step = _mm256_set1_epi32(8 * pass.v_per_column);
  const __m256i u_low = _mm256_set1_epi32(pass.u_low), u_high = _mm256_set1_epi32(pass.u_high);
  const __m256i v_low = _mm256_set1_epi32(pass.v_low), v_high = _mm256_set1_epi32(pass.v_high);
  const __m256i fraction_mask = _mm256_set1_epi32(pass.nearest ? 0 : (1 << kWeightBits) - 1);
  const __m256i one = _mm256_set1_epi32(1 << kWeightBits);
  const __m256i stride = _mm256_set1_epi32(pass.stride);
  __m256i u = _mm256_add_epi32(_mm256_set1_epi32(u_start),
                               _mm256_mullo_epi32(lanes, _mm256_set1_epi32(pass.u_per_column)));
  __m256i v = _mm256_add_epi32(_mm256_set1_epi32(v_start),
                               _mm256_mullo_epi32(lanes, _mm256_set1_epi32(pass.v_per_column)));
  for (int i = 0; i < pass.columns; i += 8) {
    const __m256i cu = kInside ? u : _mm256_min_epi32(_mm256_max_epi32(u, u_low), u_high);
    const __m256i cv = kInside ? v : _mm256_min_epi32(_mm256_max_epi32(v, v_low), v_high);
    u = _mm256_add_epi32(u, u_step);
    v = _mm256_add_epi32(v, v_step);
    storeLanes(row.cell + i,
               _mm256_add_epi32(_mm256_mullo_epi32(_mm256_srai_epi32(cv, kCoordinateBits), stride),
                                _mm256_srai_epi32(cu, kCoordinateBits)));
    const __m256i fu = _mm256_and_si256(_mm256_srli_epi32(cu, kFractionShift), fraction_mask);
    const __m256i fv = _mm256_and_si256(_mm256_srli_epi32(cv, kFractionShift), fraction_mask);
    const __m256i w11 = _mm256_mulhrs_epi16(fu, _mm256_slli_epi32(fv, 1));
    const __m256i w01 = _mm256_sub_epi32(fu, w11);
    const __m256i w10 = _mm256_sub_epi32(fv, w11);
    const __m256i w00 = _mm256_sub_epi32(one, _mm256_add_epi32(fu, w10));
    storeLanes(row.weights + 2 * i, _mm256_or_si256(w00, _mm256_slli_epi32(w01, 16)));
    storeLanes(row.weights + 2 * i + 8, _mm256_or_si256(w10, _mm256_slli_epi32(w11, 16)));
  }
}

template <bool kPairs>
inline void fetch(const BlockPass& pass, Row& row) {
  if constexpr (kPairs) {
    const std::ptrdiff_t below = 2 * std::ptrdiff_t(pass.stride);
    for (int i = 0; i < pass.columns; ++i) {
      const std::uint8_t* const cell = pass.cells + 2 * std::ptrdiff_t(row.cell[i]);
      const int at = 2 * i - (i & 7);
      row.taps[at] = loadTaps(cell);
      row.taps[at + 8] = loadTaps(cell + below);
    }
  } else {
    for (int i = 0; i < pass.columns; i += 8) {
      for (int lane = i; lane < i + 8; ++lane) {
        row.taps[lane] = loadTaps(pass.cells + 2 * std::ptrdiff_t(row.cell[lane]));
      }
    }
  }
}

template <bool kPairs>
inline void blend(const BlockPass& pass, const Row& row, float* intensity, std::int32_t* flag) {
  const __m256i flags = _mm256_set1_epi32(pass.flags);
  const __m256i zero = _mm256_setzero_si256();
  const __m256 value_unit = _mm256_set1_ps(1.0F / float(1 << kWeightBits));
  const __m256 alpha_unit = _mm256_set1_ps(1.0F / (255.0F * float(1 << kWeightBits)));
  const __m256 full = _mm256_set1_ps(255.0F);
  for (int i = 0; i < pass.columns; i += 8) {
    const Sums sums = sumTaps<kPairs>(row, i);
    const __m256 value = _mm256_mul_ps(_mm256_cvtepi32_ps(sums.value), value_unit);
    const __m256 minus_alpha = _mm256_mul_ps(_mm256_cvtepi32_ps(sums.minus_alpha), alpha_unit);
    const __m256 below = _mm256_load_ps(intensity + i);
    const __m256 kept = _mm256_add_ps(below, _mm256_mul_ps(below, minus_alpha));
    _mm256_store_ps(intensity + i, _mm256_min_ps(_mm256_add_ps(kept, value), full));
    const __m256i unseen = _mm256_cmpeq_epi32(_mm256_or_si256(sums.value, sums.minus_alpha), zero);
    storeLanes(flag + i, _mm256_blendv_epi8(flags, loadLanes(flag + i), unseen));
  }
}

template <bool kPairs, bool kInside>
void paint(const BlockPass& pass, SampleBlock& block) {
  Row row;
  for (int j = pass.first_row; j < pass.first_row + pass.rows; ++j) {
    locate<kInside>(pass, pass.u + j * pass.u_per_row + pass.first_column * pass.u_per_column,
                    pass.v + j * pass.v_per_row + pass.first_column * pass.v_per_column, row);
    fetch<kPairs>(pass, row);
    const int at = j * kBlockEdge + pass.first_column;
    blend<kPairs>(pass, row, block.intensity + at, block.flags + at);
  }
}

}  // namespace

void paintAvx2(const BlockPass& pass, SampleBlock& block) {
  if (pass.layout == cells::CellLayout::Pairs) {
    pass.inside ? paint<true, true>(pass, block) : paint<true, false>(pass, block);
  } else {
    pass.inside ? paint<false, true>(pass, block) : paint<false, false>(pass, block);
  }
}

bool avx2Compiled() { return true; }

#else

void paintAvx2(const BlockPass& pass, SampleBlock& block) { paintPortable(pass, block); }
bool avx2Compiled() { return false; }

#endif

}  // namespace mapwright::render
