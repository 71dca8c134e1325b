// All cells that came, each where it belongs: pieces on the same lattice of cells in one sheet, others in
// sheets of their own. Where pieces overlap, the newest is seen.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "map/map_part.h"
#include "regions/region_sheet.h"

namespace mapwright::regions {

/// Why a piece could not be placed.
enum class Misfit {
  None,
  Unusable,    // its reference says nothing: map::whyUnusable
  FewerCells,  // than its width and height say
  OtherFrame,  // than the pieces before it
  TooLarge,    // for one answer
};

class RegionCells {
 public:
  /// One answer may have so many cells; of more nothing is taken.
  static constexpr std::int64_t kMostOfPiece = std::int64_t(64) << 20;
  /// A map whose cells lie on more lattices than this loses the sheet that was written to longest ago.
  static constexpr std::size_t kMostSheets = 4;

  /// What is wrong with a piece that has cells; None: it can be placed.
  Misfit misfitOf(const map::GridPart& part) const;
  /// Places it. False: it cannot be (misfitOf), and nothing has changed.
  bool put(const map::GridPart& part);
  /// Forgets what lies in `rect`. True when there was anything.
  bool forget(const geometry::WorldRect& rect);
  void clear();

  /// The one that was written to last comes last.
  const std::vector<std::shared_ptr<RegionSheet>>& sheets() const { return sheets_; }
  /// The frame of all pieces; empty while none has named one.
  const std::string& frame() const { return frame_; }
  std::size_t bytes() const;
  /// Of all that has been placed, the outermost bounds; empty = nothing.
  const geometry::WorldRect& reach() const { return reach_; }

 private:
  std::vector<std::shared_ptr<RegionSheet>> sheets_;
  std::string frame_;
  geometry::WorldRect reach_;
};

}  // namespace mapwright::regions
