#include "cells/reduce_cells.h"

#include <cstring>

namespace mapwright::cells {

namespace {

// Two neighbouring cells are read as one 16-bit lane: this avoids shuffles in the loop, so that every
// compiler vectorises it. The byte order does not matter: both halves are treated alike.
void reduceFolded(const std::uint8_t* upper, const std::uint8_t* lower, std::uint8_t* out,
                  std::size_t out_cells) {
  for (std::size_t i = 0; i < out_cells; ++i) {
    std::int16_t a = 0;
    std::int16_t b = 0;
    std::memcpy(&a, upper + 2 * i, 2);
    std::memcpy(&b, lower + 2 * i, 2);
    const auto low = [](std::int16_t pair) {
      return std::int16_t(std::int16_t(std::uint16_t(pair) << 8) >> 8);
    };
    const auto high = [](std::int16_t pair) { return std::int16_t(pair >> 8); };
    const auto sum = std::int16_t(low(a) + high(a) + low(b) + high(b));
    const auto mean = std::int16_t(std::int16_t(sum + 2) >> 2);
    const std::int16_t any = std::int16_t(a | b);
    out[i] = std::uint8_t((mean == 0 && any != 0) ? std::int16_t(-1) : mean);
  }
}

void reducePairs(const std::uint8_t* upper, const std::uint8_t* lower, std::uint8_t* out,
                 std::size_t out_cells) {
  for (std::size_t i = 0; i < out_cells; ++i) {
    const std::uint8_t* a = upper + 4 * i;
    const std::uint8_t* b = lower + 4 * i;
    const unsigned value = unsigned(a[0]) + a[2] + b[0] + b[2];
    const unsigned alpha = unsigned(a[1]) + a[3] + b[1] + b[3];
    const unsigned mean_value = (value + 2) / 4;
    const unsigned mean_alpha = (alpha + 2) / 4;
    const bool lost = (mean_value | mean_alpha) == 0 && (value | alpha) != 0;
    out[2 * i] = std::uint8_t(mean_value);
    out[2 * i + 1] = std::uint8_t(lost ? 1 : mean_alpha);
  }
}

}  // namespace

void reduceRows(CellLayout layout, const std::uint8_t* upper, const std::uint8_t* lower, std::uint8_t* out,
                std::size_t out_cells) {
  if (layout == CellLayout::Folded) {
    reduceFolded(upper, lower, out, out_cells);
  } else {
    reducePairs(upper, lower, out, out_cells);
  }
}

}  // namespace mapwright::cells
