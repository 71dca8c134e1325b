// The levels of a texture: dense while they are made, sparse once they are kept. Private to CellTexture.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "cells/cell_texture.h"

namespace mapwright::cells {

inline constexpr int kBlock = DenseCells::kBlock;

inline int bytesPerCell(CellLayout layout) { return layout == CellLayout::Folded ? 1 : 2; }

/// A level while it is made: rows padded with zeros to whole blocks, an even number of them, so that
/// reduceRows may read a neighbour for every cell.
struct CellTexture::PaddedLevel {
  /// The padding is zero, the cells are not initialised.
  PaddedLevel(int width, int height, CellLayout layout);
  /// The next coarser level.
  PaddedLevel reduced() const;
  std::uint8_t* row(int v) { return bytes.get() + std::size_t(v) * stride; }
  const std::uint8_t* row(int v) const { return bytes.get() + std::size_t(v) * stride; }

  int width, height;
  CellLayout layout;
  std::size_t stride;  // bytes
  std::unique_ptr<std::uint8_t[]> bytes;
};

/// One level as the blocks that hold an observed cell, in row-major order, and a bit for every block. The
/// rank of a block's bit is its place among the kept ones: 1.5 bits a block in all, where a table of indices
/// would cost as much as a sixteenth of all cells.
struct CellTexture::Level {
  int width = 0, height = 0;
  int blocks_x = 0, blocks_y = 0;
  bool derived = false;                   // not kept: made from level 0 when asked for
  std::vector<std::uint64_t> occupied;    // bit n of word n / 64: block n is kept
  std::vector<std::uint32_t> before;      // per word of `occupied`: blocks kept before it
  std::unique_ptr<std::uint8_t[]> cells;  // kept blocks, kBlock rows of kBlock cells each
  std::size_t cells_bytes = 0;

  Level(int width, int height);
  /// Keeps the observed blocks of `padded` and returns how many cells are observed.
  std::size_t keep(const PaddedLevel& padded);
  /// Writes what keep() kept to the end of `out`; takes it from the front of `in`, false when that is too
  /// short.
  void pack(std::vector<std::uint8_t>& out) const;
  bool unpack(std::span<const std::uint8_t>& in, CellLayout layout);

  bool isOccupied(std::size_t block) const { return (occupied[block / 64] >> (block % 64) & 1) != 0; }
  /// False outside, too.
  bool isOccupied(int bx, int by) const {
    return bx < blocks_x && by < blocks_y &&
           isOccupied(std::size_t(by) * std::size_t(blocks_x) + std::size_t(bx));
  }
  /// How many blocks are kept before `block`.
  std::size_t rank(std::size_t block) const;
  std::size_t bytes() const;

  /// Calls visit(bx, cells) for every kept block of block row `by`; a kept block has `block_bytes` bytes.
  template <typename Visit>
  void eachBlock(int by, std::size_t block_bytes, Visit visit) const {
    std::size_t block = std::size_t(by) * std::size_t(blocks_x);
    const std::uint8_t* at = cells.get() + rank(block) * block_bytes;
    for (int bx = 0; bx < blocks_x; ++bx, ++block) {
      if (isOccupied(block)) {
        visit(bx, at);
        at += block_bytes;
      }
    }
  }

 private:
  std::size_t markOccupied(const PaddedLevel& padded);
  /// Fills `before`, and returns how many blocks are kept.
  std::size_t rankBlocks();
};

/// All levels of a texture: what a TextureStore moves in and out.
struct CellTexture::Body {
  CellLayout layout = CellLayout::Folded;
  std::vector<Level> levels;

  /// Levels of the right sizes, with nothing in them yet.
  Body(int width, int height, CellLayout layout);
  std::size_t bytes() const;
  std::vector<std::uint8_t> packed() const;
  /// Of a texture of the same size; false when `in` is not what packed() wrote.
  bool unpack(std::span<const std::uint8_t> in);

  bool occupiedBlock(int level, int bx, int by) const;
  void expandDerived(int level, std::uint8_t* first, std::size_t stride_bytes) const;
};

}  // namespace mapwright::cells
