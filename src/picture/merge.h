// Compares two states of a picture cell by cell, and merges my changes with theirs. Pure functions; any
// thread.
#pragma once

#include <array>
#include <atomic>
#include <bitset>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "picture/canvas.h"

namespace mapwright::picture {

/// How many cells of two grids with the same base differ, by tile of level 0; equal tiles are left out.
struct DifferenceCount {
  /// For some tiles, including equal ones.
  using Tiles = std::vector<std::pair<TileKey, std::int64_t>>;
  std::map<TileKey, std::int64_t> tiles;
  std::int64_t cells = 0;
  /// The stored counts for the tiles of a patch, and fresh ones.
  Tiles of(const Patch& touched) const;
  static Tiles counted(const EditedGrid& one, const EditedGrid& other, const Patch& touched);
  void set(const Tiles& counts);
  /// Counts the tiles of a patch again.
  void recount(const EditedGrid& one, const EditedGrid& other, const Patch& touched);
  static DifferenceCount between(const EditedGrid& one, const EditedGrid& other);

 private:
  void set(const TileKey& key, std::int64_t count);
};

/// The patch that turns `grid` into `other`. Both have the same size and code (sameShape). Empty if
/// cancelled.
bool sameShape(const grids::GridPyramid& one, const grids::GridPyramid& other);
Patch differenceTo(const EditedGrid& grid, const grids::GridPyramid& other,
                   const std::atomic<bool>* cancelled = nullptr);

/// A piece of a row whose cells all become the same kind.
struct ChangedRun {
  CellRect cells;
  Kind becomes = Kind::Free;
};
/// What a patch would change in `grid`, before it is applied: the first runs of each tile, at most
/// `most_runs`, and the number of cells that become each kind, counting all.
struct Changes {
  std::vector<ChangedRun> runs;
  bool all = true;  // of them
  std::array<std::int64_t, kKinds> become{};
};
Changes changesOf(const EditedGrid& grid, const Patch& patch, std::size_t most_runs);

/// A set of cells of a grid, by tile of level 0; row-major.
struct CellSet {
  using OfTile = std::bitset<kTileCells>;
  std::map<TileKey, OfTile> tiles;
  void unite(const CellSet& other);
  /// How many of them differ between the two, and their bounds.
  std::pair<std::int64_t, CellRect> differing(const EditedGrid& one, const EditedGrid& other) const;
};
/// Makes these cells of `grid` equal to those of `source`, which has the same base.
Patch copied(const EditedGrid& grid, const EditedGrid& source, const CellSet& cells);

/// Merges `mine` with a changed base: theirs where I changed nothing, mine where they did not, and where both
/// changed something different, mine until the user decides.
struct Merge {
  Patch patch;             // for mine
  CellSet conflicts;       // that both have changed
  std::int64_t taken = 0;  // cells that now come from theirs
};
/// `theirs`: what they did to the base (differenceTo).
Merge mergeCells(const EditedGrid& mine, const Patch& theirs, const EditedGrid& base);

/// The same for steps in the undo history: their cells before and after are updated as if theirs had been
/// there from the start. So undo reverts exactly what was done here. One thread at a time.
class Rebase {
 public:
  /// As for mergeCells, which made `merge` for the present grid.
  Rebase(const Patch& theirs, std::shared_ptr<const EditedGrid> base);
  /// Registers what has been merged already: steps share tiles with the grid.
  void know(const Merge& merge);
  /// For a patch of a grid with the same base. Its coarser levels may have to be rebuilt afterwards.
  void apply(Patch& patch);

 private:
  TileState rebased(const TileKey& key, const TileState& state);
  std::map<TileKey, TileState> theirs_;
  std::shared_ptr<const EditedGrid> base_;
  struct Made {
    TileState from, to;
  };
  std::map<std::pair<TileKey, const std::uint8_t*>, Made> made_;
};

/// Restores the coarser levels of a patch. `done`: the patch is applied to the grid; otherwise it will be.
Patch withCoarserLevels(const EditedGrid& grid, const Patch& patch, bool done);

}  // namespace mapwright::picture
