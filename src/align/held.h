// How exactly the walls that both maps show hold a place: few of them, or coarse ones, leave it loose. Pure
// functions.
#pragma once

#include "align/fit.h"

namespace mapwright::align {

/// The best fit near `pose` by walls that both maps saw from the same side. What one map saw from behind lies
/// beside by the thickness of the wall and pulls the fit; where only few are left, `pose` as it is.
geometry::Pose2 sharpened(const Sheets& sheets, const Points& points, const geometry::Pose2& pose);

/// Whether a sharpened place is known to 5 cm, where those walls are, and 0.3 degrees.
bool heldByWalls(const Sheets& sheets, const Points& points, const geometry::Pose2& pose);

}  // namespace mapwright::align
