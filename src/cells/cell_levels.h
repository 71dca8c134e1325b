// The levels of a texture: dense while they are built, sparse once they are stored. Private to CellTexture.
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

/// A level under construction: rows padded with zeros to whole blocks, an even number of them, so that
/// reduceRows can read a neighbour of every cell.
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

/// One level, stored as the blocks that contain an observed cell, in row-major order, with a bit for every
/// block. The rank of a block's bit is its index among the stored ones: this takes 1.5 bits per block, while
/// a table of indices would cost up to a sixteenth of all cells.
struct CellTexture::Level {
  int width = 0, height = 0;
  int blocks_x = 0, blocks_y = 0;
  bool derived = false;                   // not stored: computed from level 0 on demand
  std::vector<std::uint64_t> occupied;    // bit n of word n / 64: block n is stored
  std::vector<std::uint32_t> before;      // per word of `occupied`: number of stored blocks before it
  std::unique_ptr<std::uint8_t[]> cells;  // stored blocks, kBlock rows of kBlock cells each
  std::size_t cells_bytes = 0;

  Level(int width, int height);
  /// Stores the observed blocks of `padded` and returns how many cells are observed.
  std::size_t keep(const PaddedLevel& padded);
  /// Appends the stored blocks to `out`; reads them from the front of `in`, false if that is too short.
  void pack(std::vector<std::uint8_t>& out) const;
  bool unpack(std::span<const std::uint8_t>& in, CellLayout layout);

  bool isOccupied(std::size_t block) const { return (occupied[block / 64] >> (block % 64) & 1) != 0; }
  /// False outside.
  bool isOccupied(int bx, int by) const {
    return bx < blocks_x && by < blocks_y &&
           isOccupied(std::size_t(by) * std::size_t(blocks_x) + std::size_t(bx));
  }
  /// How many blocks are stored before `block`.
  std::size_t rank(std::size_t block) const;
  std::size_t bytes() const;

  /// Calls visit(bx, cells) for every stored block of block row `by`; a block has `block_bytes` bytes.
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
  /// Fills `before` and returns how many blocks are stored.
  std::size_t rankBlocks();
};

/// All levels of a texture: what a TextureStore moves in and out.
struct CellTexture::Body {
  CellLayout layout = CellLayout::Folded;
  std::vector<Level> levels;

  /// Empty levels of the right sizes.
  Body(int width, int height, CellLayout layout);
  std::size_t bytes() const;
  std::vector<std::uint8_t> packed() const;
  /// For a texture of the same size; false if `in` was not written by packed().
  bool unpack(std::span<const std::uint8_t> in);

  bool occupiedBlock(int level, int bx, int by) const;
  void expandDerived(int level, std::uint8_t* first, std::size_t stride_bytes) const;
};

/// Writes `out_cells` cells, each the average of 2x2 cells of the rows `upper` and `lower` (2 * out_cells
/// cells each). Unknown cells count as zero, as in an area average of the composed picture. A cell with an
/// observed child is observed: if the average is zero it becomes (0, 1), which means delta == 0. Folded cells
/// keep the net of value and alpha; pairs keep both.
void reduceRows(CellLayout layout, const std::uint8_t* upper, const std::uint8_t* lower, std::uint8_t* out,
                std::size_t out_cells);

}  // namespace mapwright::cells
