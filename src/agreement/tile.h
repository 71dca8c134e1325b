// What submaps say about each other in one square of the world. Pure functions, any thread. Source:
// docs/protocols/cartographer-submaps.md, "Disagreement".
//
// The world is a lattice of square cells: cell (i, j) covers [i, i+1) x [j, j+1) times the edge of a cell. A
// submap is read at the centre of each lattice cell: the texture cell that contains it, without
// interpolation. It holds the cell *occupied* if that texture cell has a probability above 0.6, and saw it
// *free* if it is below 0.4 (readingOf()).
//
// A lattice cell contradicts where one submap holds it occupied and another one saw it free and holds no
// lattice cell occupied whose centre is within `tolerance_cells` cells of its centre, straight (Euclidean):
// the same wall, seen a little beside, is no contradiction.
#pragma once

#include <array>
#include <atomic>
#include <compare>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "geometry/rect.h"
#include "map/submap.h"
#include "render/compositor.h"
#include "render/dense_cache.h"

namespace mapwright::cells {
struct CellPair;
}

namespace mapwright::agreement {

inline constexpr double kFinestCellM = 0.01, kCoarsestCellM = 1;
inline constexpr int kMostTolerance = 40;  // cells

struct Rules {
  double cell_m = 0.05;     // kFinestCellM .. kCoarsestCellM
  int tolerance_cells = 4;  // 0 .. kMostTolerance
  bool operator==(const Rules&) const = default;
};

enum class Reading : std::uint8_t { Unseen, Free, Undecided, Occupied };

/// What one cell of a texture says. Where value or alpha is 0, as in all log-odds textures, value - alpha is
/// 128 - k, and k = 1..255 stands for a probability of 0.1..0.9 in equal steps of log-odds: occupied from k =
/// 152 on, free up to k = 104. Others are opaque grays: the probability is 1 - intensity / 255 of the cell
/// composed on 128.
Reading readingOf(cells::CellPair cell);

/// A square of 1 m: [x, x+1) x [y, y+1). A cell belongs to the square that contains its centre.
struct Square {
  std::int32_t x = 0, y = 0;
  auto operator<=>(const Square&) const = default;
};

Square squareAt(double x, double y);

/// A submap that disagrees, in so many of the cells of a square that contradict. At most 101 x 101 have their
/// centres in one.
struct Part {
  map::SubmapId id;
  std::uint16_t occupied = 0;  // it holds them occupied, and others saw them free
  std::uint16_t free = 0;      // the other way round
  int cells() const { return occupied + free; }
  bool operator==(const Part&) const = default;
};

struct SquareFindings {
  std::uint64_t cells = 0;    // that contradict
  std::vector<Part> submaps;  // ascending ids
};

/// Tile (column, row) covers the lattice cells [column * kTileCells, (column + 1) * kTileCells) along x, and
/// the same along y with its row.
struct TileKey {
  std::int32_t column = 0, row = 0;
  auto operator<=>(const TileKey&) const = default;
};

inline constexpr int kTileCells = 256;

/// The findings of one tile. Column 0 is that of the lowest x, row 0 that of the lowest y.
class Tile {
 public:
  /// How many submaps saw the cell; kManySubmaps = so many, or more.
  std::uint8_t seenBy(int column, int row) const { return seen_by[at(column, row)]; }
  bool isOccupied(int column, int row) const { return has(occupied, column, row); }  // says one submap
  bool isContradicted(int column, int row) const { return has(contradicted, column, row); }
  static constexpr std::uint8_t kManySubmaps = 255;

  static constexpr int kWords = kTileCells / 64;  // a row
  using Bits = std::array<std::uint64_t, std::size_t(kTileCells* kWords)>;
  // Bit n of word m of a row is column 64 * m + n.
  Bits occupied{}, contradicted{};
  std::array<std::uint8_t, std::size_t(kTileCells* kTileCells)> seen_by{};  // row by row
  std::array<std::uint32_t, kManySubmaps + 1> cells_seen_by{};              // [n] = cells with seenBy() n
  std::uint64_t occupied_cells = 0, contradicted_cells = 0, seen_cells = 0;
  std::map<Square, SquareFindings> squares;  // those with a contradicted cell in this tile

 private:
  static std::size_t at(int column, int row) { return std::size_t(row) * kTileCells + std::size_t(column); }
  static bool has(const Bits& bits, int column, int row) {
    return (bits[std::size_t(row * kWords + column / 64)] >> (column % 64) & 1) != 0;
  }
};

/// All that is needed to make a tile.
struct TileTask {
  TileKey key;
  Rules rules;
  std::vector<render::PlacedTexture> near;  // all submaps that touch reachOf(key, rules)
  std::uint64_t generation = 0;             // of its Survey
};

geometry::WorldRect boundsOf(TileKey key, double cell_m);
/// The centre of a cell of a tile, in the world.
Eigen::Vector2d centreOf(TileKey key, int column, int row, double cell_m);
/// Submaps beyond do not matter to the tile.
geometry::WorldRect reachOf(TileKey key, const Rules& rules);

/// Null if cancelled, which is polled (it may be null), and never null otherwise. One core; memory: 16 KB for
/// each submap.
std::shared_ptr<const Tile> makeTile(const TileTask& task, render::DenseCache& cache,
                                     const std::atomic<bool>* cancelled = nullptr);

}  // namespace mapwright::agreement
