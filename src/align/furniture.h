// Two floors of one building can have the same walls. What stands in their rooms tells them apart. Pure
// functions.
#pragma once

#include <cstddef>

#include "align/plan.h"
#include "geometry/pose.h"

namespace mapwright::align {

/// Pieces that stand free, of both maps, where the other one saw the place; `again`: those that are there,
/// too.
struct Furniture {
  std::size_t pieces = 0, again = 0;
  /// There are many, and as good as none is there again.
  bool allDiffers() const;
};
Furniture furnitureOf(const Plan& old_map, const Plan& new_map, const geometry::Pose2& pose);

}  // namespace mapwright::align
