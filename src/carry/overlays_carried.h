// All overlays of an old map, on a new one. Pure; not for the GUI thread.
#pragma once

#include <vector>

#include "carry/carried.h"
#include "overlays/overlay_document.h"

namespace mapwright::carry {

struct CarriedFeature {
  std::size_t feature = 0;     // its index in the old document
  overlays::Feature moved;     // as it would be on the new map
  Carried carried;             // the verdict on the worst of its group, if `with` is not empty
  bool there_already = false;  // the new map has it, by its id or else in the same place: that stays as it is
  bool one_there = false;      // one of its group is: it is left out, too
  bool box_removed = false;    // its `bbox`, which did not fit it on the old map
  /// Others that it refers to, or that refer to it: they go together or not at all. Indices of the old
  /// document.
  std::vector<std::size_t> with = {};
};

/// In the order of the old document. What is no feature with usable coordinates is left out.
std::vector<CarriedFeature> carriedOverlays(const Site& site, const overlays::OverlayDocument& old_overlays,
                                            const overlays::OverlayDocument& new_overlays,
                                            const render::PlacedGrid& new_map, const CarryOptions& options);

}  // namespace mapwright::carry
