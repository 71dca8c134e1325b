// How two states of a picture differ, cell by cell, and what becomes of mine when theirs has changed too.
// Pure functions; any thread.
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

/// How many cells of one grid are others in another one of the same base, by tile of level 0; tiles without
/// any are left out.
struct DifferenceCount {
  /// Of some tiles, those without any included.
  using Tiles = std::vector<std::pair<TilePlace, std::int64_t>>;
  std::map<TilePlace, std::int64_t> tiles;
  std::int64_t cells = 0;
  /// What is counted of the tiles of a patch now, and what would be, were they looked at.
  Tiles of(const Patch& touched) const;
  static Tiles counted(const EditedGrid& one, const EditedGrid& other, const Patch& touched);
  void set(const Tiles& counts);
  /// Counts the tiles of a patch anew.
  void recount(const EditedGrid& one, const EditedGrid& other, const Patch& touched);
  static DifferenceCount between(const EditedGrid& one, const EditedGrid& other);

 private:
  void set(const TilePlace& place, std::int64_t count);
};

/// What makes `other` of `grid`: a patch for it. Both have the same size and code (sameShape). Nothing when
/// cancelled.
bool sameShape(const grids::GridPyramid& one, const grids::GridPyramid& other);
Patch differenceTo(const EditedGrid& grid, const grids::GridPyramid& other,
                   const std::atomic<bool>* cancelled = nullptr);

/// A piece of a row whose cells all become of one kind.
struct ChangedRun {
  CellRect cells;
  Kind becomes = Kind::Free;
};
/// What a patch changes of `grid`, which it has not been applied to yet: the first runs of each tile, no more
/// than `most_runs`, and how many cells become of each kind, all counted.
struct Changes {
  std::vector<ChangedRun> runs;
  std::array<std::int64_t, kKinds> become{};
};
Changes changesOf(const EditedGrid& grid, const Patch& patch, std::size_t most_runs);

/// Some cells of a grid, whichever they are of each tile of level 0; row-major.
struct CellSet {
  using OfTile = std::bitset<std::size_t(Canvas::kEdge) * Canvas::kEdge>;
  std::map<TilePlace, OfTile> tiles;
  void unite(const CellSet& other);
  /// How many of them are others in the one than in the other, and the bounds of these.
  std::pair<std::int64_t, CellRect> differing(const EditedGrid& one, const EditedGrid& other) const;
};
/// Makes these cells of `grid` as they are in `source`, of the same base.
Patch copied(const EditedGrid& grid, const EditedGrid& source, const CellSet& cells);

/// What becomes of `mine` when the picture that it was made of has become another: theirs where I have
/// changed nothing, mine where they have not, and where both have, differently, mine until somebody decides.
struct Merge {
  Patch patch;             // for mine
  CellSet conflicts;       // that both have changed
  std::int64_t taken = 0;  // cells that are theirs now
};
/// `theirs`: what they did to the base (differenceTo).
Merge mergeCells(const EditedGrid& mine, const Patch& theirs, const EditedGrid& base);

/// The same for steps of the past: their cells before and after become what they would be, had theirs been
/// there from the beginning. So undoing takes back what was done here and nothing else. One thread at a time.
class Rebase {
 public:
  /// As for mergeCells, which has made `merge` of the grid as it stands.
  Rebase(const Patch& theirs, std::shared_ptr<const EditedGrid> base);
  /// What has been merged already: steps share their tiles with the grid.
  void know(const Merge& merge);
  /// Of a patch for a grid over the same base. Its coarser levels may have to be made anew afterwards.
  void apply(Patch& patch);

 private:
  TileState rebased(const TilePlace& place, const TileState& state);
  std::map<TilePlace, TileState> theirs_;
  std::shared_ptr<const EditedGrid> base_;
  struct Made {
    TileState from, to;
  };
  std::map<std::pair<TilePlace, const std::uint8_t*>, Made> made_;
};

/// A patch that has lost its coarser levels, complete again. `done`: the grid has it, else it is to come.
Patch withCoarserLevels(const EditedGrid& grid, const Patch& patch, bool done);

}  // namespace mapwright::picture
