// All received cells at their positions: pieces on the same cell lattice share a sheet, others get sheets of
// their own. Where pieces overlap, the newest is visible.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "map/map_part.h"

namespace mapwright::regions {

class RegionSheet;

/// Why a piece cannot be placed.
enum class Misfit {
  None,
  Unusable,    // its reference says nothing: map::unusableReason
  FewerCells,  // than its width and height say
  OtherFrame,  // than the pieces before it
  TooLarge,    // for one answer
};

class RegionCells {
 public:
  /// The maximum number of cells in an answer; larger ones are ignored.
  static constexpr std::int64_t kMostOfPiece = std::int64_t(64) << 20;
  /// If the cells of a map are on more lattices than this, the least recently written sheet is dropped.
  static constexpr std::size_t kMostSheets = 4;

  /// What is wrong with a piece that has cells; None: it can be placed.
  Misfit misfitOf(const map::GridPart& part) const;
  /// Places it. False: impossible (see misfitOf), and nothing has changed.
  bool put(const map::GridPart& part);
  /// Drops everything in `rect`. True if there was anything.
  bool forget(const geometry::WorldRect& rect);

  /// The one written last is at the end.
  const std::vector<std::shared_ptr<RegionSheet>>& sheets() const { return sheets_; }
  /// The frame of all pieces; empty until one names it.
  const std::string& frame() const { return frame_; }
  std::size_t bytes() const;
  /// The bounds of everything placed; empty = nothing.
  const geometry::WorldRect& reach() const { return reach_; }

 private:
  std::vector<std::shared_ptr<RegionSheet>> sheets_;
  std::string frame_;
  geometry::WorldRect reach_;
};

}  // namespace mapwright::regions
