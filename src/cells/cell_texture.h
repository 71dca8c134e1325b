// The cells of one submap slice in memory: compact when stored, dense when composed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace mapwright::cells {

class TextureStore;

/// One cell as Cartographer paints it: premultiplied value (0..255) and alpha (0..255).
/// Observed iff not (0, 0). Source: docs/protocols/cartographer-submaps.md, "Containers and cell layouts",
/// "Composition".
struct CellPair {
  std::uint8_t value = 0;
  std::uint8_t alpha = 0;
  bool operator==(const CellPair&) const = default;
};

/// How the cells of a texture are stored. All known Cartographer variants fit into one signed byte without
/// loss; others (INTENSITY, foreign pairs) keep their pairs.
enum class CellLayout : std::uint8_t {
  Folded,  // int8 d: 0 = unknown; d > 0: value d, alpha 0; d < 0: value 0, alpha -d (never -128)
  Pairs,   // uint8 value, uint8 alpha
};

/// One level of a texture laid out densely for the compositor. A frame of zero cells, kBorder wide on every
/// side, surrounds the cells so that a bilinear tap next to an edge reads "unknown", and kSlack zero bytes
/// follow the last row so that a 32-bit load at any cell is inside the buffer. Cell (column u, row v) of the
/// level starts at data[((v + kBorder) * stride + (u + kBorder)) * bytes_per_cell].
struct DenseCells {
  static constexpr int kBorder = 2;
  static constexpr int kSlack = 32;
  static constexpr int kBlock = 8;  // edge of the blocks of `occupied_sum`

  CellLayout layout = CellLayout::Folded;
  int bytes_per_cell = 1;     // 1 folded, 2 pairs
  int width = 0, height = 0;  // columns, rows of this level, without the border
  int stride = 0;             // cells per row including the border
  std::vector<std::uint8_t> data;

  /// Summed-area table over kBlock x kBlock cells: how many blocks hold an observed cell.
  /// (blocks_x+1)*(blocks_y+1) entries, first row and column zero. Lets the compositor step over empty
  /// ground.
  int blocks_x = 0, blocks_y = 0;
  std::vector<std::uint32_t> occupied_sum;

  /// True if no observed cell lies in the cell rectangle [u0,u1] x [v0,v1] (inclusive, clamped to the level).
  /// Works with whole blocks in constant time: true is certain, false may be due to another cell in a touched
  /// block.
  bool emptyWithin(int u0, int v0, int u1, int v1) const;
  std::size_t bytes() const { return data.size() + occupied_sum.size() * sizeof(std::uint32_t); }
};

/// Immutable cells of one slice with reduced levels for previews. Level 0 is exact; level n has cells 2^n
/// times as large (cell_texture.cpp describes the averaging; they are only for previews). Stored as sparse
/// blocks, so unknown areas cost almost nothing. Safe to share between threads. A TextureStore may move them
/// to disk while they are unused; that only affects speed.
class CellTexture {
 public:
  /// `pairs` has width*height elements, row-major, row 0 first. Precondition: sizes match, width, height >=
  /// 1, resolution_m finite and > 0.
  static std::shared_ptr<const CellTexture> fromPairs(int width, int height, double resolution_m,
                                                      std::span<const CellPair> pairs);
  /// The same from folded cells (CellLayout::Folded, one signed byte each, none of them -128).
  static std::shared_ptr<const CellTexture> fromFolded(int width, int height, double resolution_m,
                                                       std::span<const std::uint8_t> cells);
  ~CellTexture();
  CellTexture(const CellTexture&) = delete;
  CellTexture& operator=(const CellTexture&) = delete;

  int width() const { return width_; }                  // columns of level 0
  int height() const { return height_; }                // rows of level 0
  double resolutionM() const { return resolution_m_; }  // metres per cell of level 0
  CellLayout layout() const { return layout_; }
  int levels() const { return levels_; }  // >= 1; the last level is at most 8 cells wide and high
  std::size_t observedCells() const { return observed_; }
  std::size_t bytes() const { return bytes_; }  // memory used by the cells while they are loaded

  /// A dense copy of `level` (0 .. levels()-1). Width of level n is ceil(width / 2^n). If the store has lost
  /// the texture (see TextureStore::Listener) nothing is observed in the copy. `storage`: memory of an
  /// earlier copy to reuse; its content does not matter.
  DenseCells expand(int level, std::vector<std::uint8_t> storage = {}) const;
  /// The exact cell; (0,0) outside.
  CellPair at(int column, int row) const;

 private:
  friend class TextureStore;
  struct PaddedLevel;
  struct Level;
  struct Body;
  CellTexture();
  void keepLevels(PaddedLevel padded);
  /// The levels, loaded from the store if there is one; null if they are lost.
  std::shared_ptr<const Body> body() const;
  // Handed to a store before anybody else has the texture, and not modified after that.
  mutable std::shared_ptr<const Body> body_;
  mutable std::shared_ptr<TextureStore> store_;
  mutable std::uint32_t index_ = 0;  // in the store
  int levels_ = 0;
  std::size_t bytes_ = 0;
  int width_ = 0, height_ = 0;
  double resolution_m_ = 0;
  CellLayout layout_ = CellLayout::Folded;
  std::size_t observed_ = 0;
};

}  // namespace mapwright::cells
