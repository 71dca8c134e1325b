#include "cells/cell_levels.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace mapwright::cells {

namespace {

int blocksAlong(int cells) { return (cells + kBlock - 1) / kBlock; }

std::uint64_t loadWord(const std::uint8_t* at) {
  std::uint64_t word = 0;
  std::memcpy(&word, at, sizeof word);
  return word;
}

/// How many of the eight folded cells in a word, or of the four pairs, are not zero: one bit per cell, to be
/// summed.
std::uint64_t observedLanes(std::uint64_t word, CellLayout layout) {
  if (layout == CellLayout::Pairs) {
    constexpr std::uint64_t kLow = 0x7fff7fff7fff7fff;
    return ((((word & kLow) + kLow) | word) >> 15) & 0x0001000100010001;
  }
  constexpr std::uint64_t kLow = 0x7f7f7f7f7f7f7f7f;
  return ((((word & kLow) + kLow) | word) >> 7) & 0x0101010101010101;
}

std::size_t sumOfLanes(std::uint64_t lanes, CellLayout layout) {
  return layout == CellLayout::Pairs ? std::size_t((lanes * 0x0001000100010001) >> 48)
                                     : std::size_t((lanes * 0x0101010101010101) >> 56);
}

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

CellTexture::PaddedLevel::PaddedLevel(int width_, int height_, CellLayout layout_)
    : width(width_),
      height(height_),
      layout(layout_),
      stride(std::size_t(blocksAlong(width_)) * kBlock * std::size_t(bytesPerCell(layout_))),
      bytes(std::make_unique_for_overwrite<std::uint8_t[]>(stride *
                                                           (std::size_t(height) + std::size_t(height % 2)))) {
  const std::size_t used = std::size_t(width) * std::size_t(bytesPerCell(layout));
  if (used < stride) {
    for (int v = 0; v < height; ++v) {
      std::memset(row(v) + used, 0, stride - used);
    }
  }
  if (height % 2 != 0) {
    std::memset(row(height), 0, stride);
  }
}

CellTexture::PaddedLevel CellTexture::PaddedLevel::reduced() const {
  PaddedLevel coarse((width + 1) / 2, (height + 1) / 2, layout);
  for (int v = 0; v < coarse.height; ++v) {
    reduceRows(layout, row(2 * v), row(2 * v + 1), coarse.row(v), std::size_t(coarse.width));
  }
  return coarse;
}

CellTexture::Level::Level(int width_, int height_)
    : width(width_), height(height_), blocks_x(blocksAlong(width_)), blocks_y(blocksAlong(height_)) {}

std::size_t CellTexture::Level::rank(std::size_t block) const {
  const std::uint64_t earlier = occupied[block / 64] & ((std::uint64_t(1) << (block % 64)) - 1);
  return before[block / 64] + std::size_t(std::popcount(earlier));
}

std::size_t CellTexture::Level::bytes() const {
  return sizeof(Level) + occupied.capacity() * sizeof(std::uint64_t) +
         before.capacity() * sizeof(std::uint32_t) + cells_bytes;
}

/// Fills `occupied` and `before`, and returns how many blocks to store.
std::size_t CellTexture::Level::markOccupied(const PaddedLevel& padded) {
  const std::size_t blocks = std::size_t(blocks_x) * std::size_t(blocks_y);
  const std::size_t row_bytes = std::size_t(kBlock) * std::size_t(bytesPerCell(padded.layout));
  const std::size_t words_per_block = row_bytes / sizeof(std::uint64_t);
  const std::size_t words_per_row = words_per_block * std::size_t(blocks_x);
  occupied.assign((blocks + 63) / 64, 0);

  std::vector<std::uint64_t> any(words_per_row);
  std::size_t kept = 0;
  for (int by = 0; by < blocks_y; ++by) {
    std::fill(any.begin(), any.end(), 0);
    const int end = std::min(height, (by + 1) * kBlock);
    for (int v = by * kBlock; v < end; ++v) {
      const std::uint8_t* row = padded.row(v);
      for (std::size_t i = 0; i < words_per_row; ++i) {
        any[i] |= loadWord(row + i * sizeof(std::uint64_t));
      }
    }
    for (std::size_t bx = 0; bx < std::size_t(blocks_x); ++bx) {
      const std::uint64_t seen = any[bx * words_per_block] | any[(bx + 1) * words_per_block - 1];
      const std::size_t block = std::size_t(by) * std::size_t(blocks_x) + bx;
      occupied[block / 64] |= std::uint64_t(seen != 0) << (block % 64);
      kept += seen != 0;
    }
  }
  rankBlocks();
  return kept;
}

std::size_t CellTexture::Level::rankBlocks() {
  before.assign(occupied.size(), 0);
  std::uint32_t earlier = 0;
  for (std::size_t i = 0; i < occupied.size(); ++i) {
    before[i] = earlier;
    earlier += std::uint32_t(std::popcount(occupied[i]));
  }
  return earlier;
}

void CellTexture::Level::pack(std::vector<std::uint8_t>& out) const {
  const auto* bits = reinterpret_cast<const std::uint8_t*>(occupied.data());
  out.insert(out.end(), bits, bits + occupied.size() * sizeof(std::uint64_t));
  out.insert(out.end(), cells.get(), cells.get() + cells_bytes);
}

bool CellTexture::Level::unpack(std::span<const std::uint8_t>& in, CellLayout layout) {
  const std::size_t blocks = std::size_t(blocks_x) * std::size_t(blocks_y);
  occupied.assign((blocks + 63) / 64, 0);
  const std::size_t bits = occupied.size() * sizeof(std::uint64_t);
  if (in.size() < bits) return false;
  std::memcpy(occupied.data(), in.data(), bits);
  in = in.subspan(bits);
  cells_bytes = rankBlocks() * std::size_t(kBlock) * kBlock * std::size_t(bytesPerCell(layout));
  if (in.size() < cells_bytes) return false;
  cells = std::make_unique_for_overwrite<std::uint8_t[]>(cells_bytes);
  std::memcpy(cells.get(), in.data(), cells_bytes);
  in = in.subspan(cells_bytes);
  return true;
}

std::size_t CellTexture::Level::keep(const PaddedLevel& padded) {
  const std::size_t row_bytes = std::size_t(kBlock) * std::size_t(bytesPerCell(padded.layout));
  const std::size_t kept = markOccupied(padded);
  cells_bytes = kept * row_bytes * kBlock;
  cells = std::make_unique_for_overwrite<std::uint8_t[]>(cells_bytes);
  std::size_t observed = 0;
  std::uint8_t* out = cells.get();
  for (std::size_t word = 0; word < occupied.size(); ++word) {
    for (std::uint64_t left = occupied[word]; left != 0; left &= left - 1) {
      const std::size_t block = word * 64 + std::size_t(std::countr_zero(left));
      const int by = int(block / std::size_t(blocks_x));
      const std::size_t bx = block % std::size_t(blocks_x);
      const int rows = std::min(kBlock, height - by * kBlock);
      const std::uint8_t* in = padded.row(by * kBlock) + bx * row_bytes;
      std::uint64_t lanes = 0;
      for (int v = 0; v < rows; ++v, in += padded.stride) {
        for (std::size_t i = 0; i < row_bytes; i += sizeof(std::uint64_t), out += sizeof(std::uint64_t)) {
          const std::uint64_t cells_here = loadWord(in + i);
          std::memcpy(out, &cells_here, sizeof cells_here);
          lanes += observedLanes(cells_here, padded.layout);
        }
      }
      observed += sumOfLanes(lanes, padded.layout);
      const std::size_t missing = std::size_t(kBlock - rows) * row_bytes;
      std::memset(out, 0, missing);
      out += missing;
    }
  }
  return observed;
}

void reduceRows(CellLayout layout, const std::uint8_t* upper, const std::uint8_t* lower, std::uint8_t* out,
                std::size_t out_cells) {
  if (layout == CellLayout::Folded) {
    reduceFolded(upper, lower, out, out_cells);
  } else {
    reducePairs(upper, lower, out, out_cells);
  }
}

}  // namespace mapwright::cells
