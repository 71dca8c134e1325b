#include "cells/cell_texture.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>

#include "cells/cell_levels.h"
#include "cells/texture_store.h"

namespace mapwright::cells {

namespace {

constexpr int kCoarsestEdge = 8;  // the last level is at most this wide and high
// Levels 1 and 2 would add a third to the memory of level 0, and can be computed from it as fast as copying
// them.
constexpr int kLastDerivedLevel = 2;
static_assert((DenseCells::kBlock >> kLastDerivedLevel) >= 1,
              "a row of blocks gives whole rows of a derived level");

static_assert(sizeof(CellPair) == 2, "pairs are read as bytes");

/// Folds one row; false if a cell cannot be folded (the row is then invalid).
bool foldRow(const std::uint8_t* pairs, std::uint8_t* out, std::size_t cells) {
  unsigned misfit = 0;
  for (std::size_t i = 0; i < cells; ++i) {
    const std::uint8_t value = pairs[2 * i];
    const std::uint8_t alpha = pairs[2 * i + 1];
    out[i] = std::uint8_t(value - alpha);
    const auto both = std::uint8_t(std::uint8_t(value != 0) & std::uint8_t(alpha != 0));
    misfit |= std::uint8_t(std::uint8_t((value | alpha) & 0x80) | both);
  }
  return misfit == 0;
}

CellPair unfold(std::uint8_t byte) {
  const int d = std::bit_cast<std::int8_t>(byte);
  return d >= 0 ? CellPair{std::uint8_t(d), 0} : CellPair{0, std::uint8_t(-d)};
}

}  // namespace

bool DenseCells::emptyWithin(int u0, int v0, int u1, int v1) const {
  u0 = std::max(u0, 0);
  v0 = std::max(v0, 0);
  u1 = std::min(u1, width - 1);
  v1 = std::min(v1, height - 1);
  if (u0 > u1 || v0 > v1) {
    return true;
  }
  const auto row = std::size_t(blocks_x) + 1;
  const std::size_t left = std::size_t(u0 / kBlock);
  const std::size_t right = std::size_t(u1 / kBlock) + 1;
  const std::size_t top = std::size_t(v0 / kBlock) * row;
  const std::size_t bottom = (std::size_t(v1 / kBlock) + 1) * row;
  return occupied_sum[bottom + right] + occupied_sum[top + left] ==
         occupied_sum[bottom + left] + occupied_sum[top + right];
}

CellTexture::CellTexture() = default;
CellTexture::~CellTexture() {
  if (store_) store_->forget(index_);
}

std::shared_ptr<const CellTexture> CellTexture::fromPairs(int width, int height, double resolution_m,
                                                          std::span<const CellPair> pairs) {
  assert(width >= 1 && height >= 1 && std::isfinite(resolution_m) && resolution_m > 0);
  assert(pairs.size() == std::size_t(width) * std::size_t(height));
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(pairs.data());
  const std::size_t row_cells = std::size_t(width);
  std::shared_ptr<CellTexture> texture(new CellTexture);
  texture->width_ = width;
  texture->height_ = height;
  texture->resolution_m_ = resolution_m;

  PaddedLevel folded(width, height, CellLayout::Folded);
  bool folds = true;
  for (int v = 0; v < height && folds; ++v) {
    folds = foldRow(bytes + std::size_t(v) * row_cells * 2, folded.row(v), row_cells);
  }
  if (folds) {
    texture->keepLevels(std::move(folded));
    return texture;
  }
  folded.bytes.reset();
  PaddedLevel plain(width, height, CellLayout::Pairs);
  for (int v = 0; v < height; ++v) {
    std::memcpy(plain.row(v), bytes + std::size_t(v) * row_cells * 2, row_cells * 2);
  }
  texture->keepLevels(std::move(plain));
  return texture;
}

std::shared_ptr<const CellTexture> CellTexture::fromFolded(int width, int height, double resolution_m,
                                                           std::span<const std::uint8_t> cells) {
  assert(width >= 1 && height >= 1 && std::isfinite(resolution_m) && resolution_m > 0);
  assert(cells.size() == std::size_t(width) * std::size_t(height));
  std::shared_ptr<CellTexture> texture(new CellTexture);
  texture->width_ = width;
  texture->height_ = height;
  texture->resolution_m_ = resolution_m;
  PaddedLevel folded(width, height, CellLayout::Folded);
  for (int v = 0; v < height; ++v) {
    std::memcpy(folded.row(v), cells.data() + std::size_t(v) * std::size_t(width), std::size_t(width));
  }
  texture->keepLevels(std::move(folded));
  return texture;
}

CellTexture::Body::Body(int width, int height, CellLayout its_layout) : layout(its_layout) {
  for (int n = 0;; ++n) {
    levels.emplace_back(width, height).derived = n >= 1 && n <= kLastDerivedLevel;
    if (std::max(width, height) <= kCoarsestEdge) return;
    width = (width + 1) / 2;
    height = (height + 1) / 2;
  }
}

std::size_t CellTexture::Body::bytes() const {
  std::size_t sum = 0;
  for (const Level& level : levels) sum += level.bytes();
  return sum;
}

std::vector<std::uint8_t> CellTexture::Body::packed() const {
  std::vector<std::uint8_t> out;
  out.reserve(bytes());
  for (const Level& level : levels) {
    if (!level.derived) level.pack(out);
  }
  return out;
}

bool CellTexture::Body::unpack(std::span<const std::uint8_t> in) {
  for (Level& level : levels) {
    if (!level.derived && !level.unpack(in, layout)) return false;
  }
  return in.empty();
}

void CellTexture::keepLevels(PaddedLevel padded) {
  layout_ = padded.layout;
  auto body = std::make_shared<Body>(width_, height_, layout_);
  for (std::size_t n = 0; n < body->levels.size(); ++n) {
    if (n > 0) padded = padded.reduced();
    if (body->levels[n].derived) continue;
    const std::size_t observed = body->levels[n].keep(padded);
    if (n == 0) observed_ = observed;
  }
  levels_ = int(body->levels.size());
  bytes_ = sizeof(CellTexture) + body->bytes();
  body_ = std::move(body);
}

std::shared_ptr<const CellTexture::Body> CellTexture::body() const {
  return store_ ? store_->bodyOf(*this) : body_;
}

DenseCells CellTexture::expand(int level, std::vector<std::uint8_t> storage) const {
  assert(level >= 0 && level < levels());
  auto held = body();
  if (!held) held = std::make_shared<const Body>(width_, height_, layout_);
  const Body& body = *held;
  const Level& shape = body.levels[std::size_t(level)];
  const std::size_t cell = std::size_t(bytesPerCell(layout_));
  DenseCells dense;
  dense.data = std::move(storage);
  dense.layout = layout_;
  dense.bytes_per_cell = int(cell);
  dense.width = shape.width;
  dense.height = shape.height;
  dense.stride = shape.width + 2 * DenseCells::kBorder;
  const std::size_t stride_bytes = std::size_t(dense.stride) * cell;
  dense.data.assign(stride_bytes * (std::size_t(shape.height) + 2 * DenseCells::kBorder) + DenseCells::kSlack,
                    0);
  std::uint8_t* first = dense.data.data() + std::size_t(DenseCells::kBorder) * stride_bytes +
                        std::size_t(DenseCells::kBorder) * cell;

  const bool lost = body.levels.front().occupied.empty();
  if (shape.derived && !lost) {
    body.expandDerived(level, first, stride_bytes);
  } else if (!lost) {
    const std::size_t row_bytes = kBlock * cell;
    for (int by = 0; by < shape.blocks_y; ++by) {
      const int rows = std::min(kBlock, shape.height - by * kBlock);
      std::uint8_t* strip = first + std::size_t(by) * kBlock * stride_bytes;
      shape.eachBlock(by, row_bytes * kBlock, [&](int bx, const std::uint8_t* block) {
        const int columns = std::min(kBlock, shape.width - bx * kBlock);
        std::uint8_t* out = strip + std::size_t(bx) * row_bytes;
        for (int v = 0; v < rows; ++v, out += stride_bytes, block += row_bytes) {
          if (columns == kBlock && cell == 1) {
            std::memcpy(out, block, kBlock);
          } else {
            std::memcpy(out, block, std::size_t(columns) * cell);
          }
        }
      });
    }
  }

  dense.blocks_x = shape.blocks_x;
  dense.blocks_y = shape.blocks_y;
  const std::size_t sums = std::size_t(shape.blocks_x) + 1;
  dense.occupied_sum.assign(sums * (std::size_t(shape.blocks_y) + 1), 0);
  for (int by = 0; by < shape.blocks_y; ++by) {
    std::uint32_t in_row = 0;
    const std::size_t above = std::size_t(by) * sums;
    for (int bx = 0; bx < shape.blocks_x; ++bx) {
      in_row += !lost && body.occupiedBlock(level, bx, by);
      dense.occupied_sum[above + sums + std::size_t(bx) + 1] =
          dense.occupied_sum[above + std::size_t(bx) + 1] + in_row;
    }
  }
  return dense;
}

bool CellTexture::Body::occupiedBlock(int level, int bx, int by) const {
  const Level& shape = levels[std::size_t(level)];
  if (!shape.derived) {
    return shape.isOccupied(bx, by);
  }
  const int edge = 1 << level;
  for (int v = by * edge; v < (by + 1) * edge; ++v) {
    for (int u = bx * edge; u < (bx + 1) * edge; ++u) {
      if (levels.front().isOccupied(u, v)) {
        return true;
      }
    }
  }
  return false;
}

void CellTexture::Body::expandDerived(int level, std::uint8_t* first, std::size_t stride_bytes) const {
  const Level& shape = levels[std::size_t(level)];
  const Level& exact = levels.front();
  const std::size_t row_bytes = std::size_t(kBlock) * std::size_t(bytesPerCell(layout));
  const std::size_t strip_stride = row_bytes * std::size_t(exact.blocks_x);
  std::vector<std::uint8_t> strip(strip_stride * kBlock);
  for (int by = 0; by < exact.blocks_y; ++by) {
    std::fill(strip.begin(), strip.end(), std::uint8_t(0));
    exact.eachBlock(by, row_bytes * kBlock, [&](int bx, const std::uint8_t* block) {
      std::uint8_t* out = strip.data() + std::size_t(bx) * row_bytes;
      for (int v = 0; v < kBlock; ++v, out += strip_stride, block += row_bytes) {
        std::memcpy(out, block, row_bytes);
      }
    });
    // Halved in place: a row is written where it was read, or above.
    std::size_t cells = std::size_t(exact.blocks_x) * kBlock;
    int rows = kBlock;
    for (int n = 1; n < level; ++n) {
      cells /= 2;
      rows /= 2;
      for (int v = 0; v < rows; ++v) {
        const std::uint8_t* upper = strip.data() + std::size_t(2 * v) * strip_stride;
        reduceRows(layout, upper, upper + strip_stride, strip.data() + std::size_t(v) * strip_stride, cells);
      }
    }
    const int top = (by * kBlock) >> level;
    rows = std::min(rows / 2, shape.height - top);
    for (int v = 0; v < rows; ++v) {
      const std::uint8_t* upper = strip.data() + std::size_t(2 * v) * strip_stride;
      reduceRows(layout, upper, upper + strip_stride, first + std::size_t(top + v) * stride_bytes,
                 std::size_t(shape.width));
    }
  }
}

CellPair CellTexture::at(int column, int row) const {
  if (column < 0 || row < 0 || column >= width_ || row >= height_) {
    return {};
  }
  const auto held = body();
  if (!held) return {};
  const Level& exact = held->levels.front();
  const std::size_t block =
      std::size_t(row / kBlock) * std::size_t(exact.blocks_x) + std::size_t(column / kBlock);
  if (!exact.isOccupied(block)) {
    return {};
  }
  const std::size_t inside = std::size_t(row % kBlock) * kBlock + std::size_t(column % kBlock);
  const std::size_t cell =
      (exact.rank(block) * kBlock * kBlock + inside) * std::size_t(bytesPerCell(layout_));
  return layout_ == CellLayout::Folded ? unfold(exact.cells[cell])
                                       : CellPair{exact.cells[cell], exact.cells[cell + 1]};
}

}  // namespace mapwright::cells
