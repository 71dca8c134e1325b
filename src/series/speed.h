// How fast a robot is, out of where it was. Pure.
#pragma once

#include <vector>

#include "series/series.h"

namespace mapwright::series {

/// Poses come with noise of centimetres: the way over the last kSpeedOver_s is what counts. What lies longer
/// ago than kSpeedReach_s says nothing any more: whoever learns of poses makes the speeds of so much later
/// anew.
inline constexpr double kSpeedOver_s = 0.2, kSpeedReach_s = 2;
/// Faster than any of these robots: it was placed anew, and did not drive.
inline constexpr double kFastest_m_s = 8;

/// Metres a second at the samples of `x` and `y` (metres, of the same times) in from_s <= t < until_s; NaN
/// where nothing is known: after a gap, and where the robot was placed anew. The result is the same whichever
/// ranges the poses came in.
std::vector<Sample> speeds(const Series& x, const Series& y, double from_s, double until_s);

}  // namespace mapwright::series
