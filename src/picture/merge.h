// How two states of a picture differ, cell by cell, and what becomes of mine when theirs has changed too.
// Pure functions; any thread.
#pragma once

#include <atomic>
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

/// What a patch changes of `grid`, which it has not been applied to yet, as pieces of rows from the top down;
/// no more than `most`.
std::vector<CellRect> changedRuns(const EditedGrid& grid, const Patch& patch, std::size_t most);

/// What becomes of `mine` when the picture that it was made of has become another: theirs where I have
/// changed nothing, mine where they have not, and where both have, differently, a conflict.
struct Merge {
  Patch patch;                 // for mine; conflicts as `take_theirs` says
  std::int64_t conflicts = 0;  // cells
  CellRect where;              // bounds of the conflicts
  std::int64_t taken = 0;      // cells that are theirs now
};
/// `theirs`: what they did to the base (differenceTo).
Merge mergeCells(const EditedGrid& mine, const Patch& theirs, const EditedGrid& base,
                 bool take_theirs = false);

}  // namespace mapwright::picture
