// What tells two places of one map on another apart: walls that the one explains and the other puts on free
// ground. Where most of a building repeats itself, both agree nearly everywhere, and only this decides. Pure
// functions.
#pragma once

#include <Eigen/Core>

#include "align/fit.h"

namespace mapwright::align {

/// A place of the old map on the new one, both ways.
struct Laid {
  Mover there, back;
};
Laid laid(const geometry::Pose2& pose);
/// With the new map mirrored: x' = `twice_axis_m` - x.
Laid laidMirrored(const geometry::Pose2& pose, double twice_axis_m);

/// Metres of wall that lie on a wall of the other map with one of two places, and on its free ground with the
/// other place.
struct Disputed {
  double for_first_m = 0, for_second_m = 0;
  /// Of the first: more than 3 m from where most of it is. One piece of furniture has none.
  double elsewhere_m = 0;
  /// How clearly the first is ahead, by standard deviations: some walls speak for a wrong place by chance.
  double ahead_sigmas = 0;
};
Disputed disputedBetween(const Sheets& sheets, const Points& points, const Laid& first, const Laid& second);

/// Whether the second one cannot be right if the first one may be.
bool refutesSecond(const Disputed& disputed);

}  // namespace mapwright::align
