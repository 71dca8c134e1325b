// Computes a robot's speed from its poses. Pure.
#pragma once

#include <vector>

#include "series/series.h"

namespace mapwright::series {

/// Poses have centimetres of noise, so the speed is averaged over kSpeedOver_s. Older data than kSpeedReach_s
/// has no effect: after new poses, recompute the speeds of that period.
inline constexpr double kSpeedOver_s = 0.2, kSpeedReach_s = 2;
/// Faster than any of these robots: its pose was reset, it did not drive.
inline constexpr double kFastest_m_s = 8;

/// Metres per second at the samples of `x` and `y` (metres, at the same times) in from_s <= t < until_s; NaN
/// if unknown: after a gap, and where the pose was reset. The result does not depend on the ranges in which
/// the poses were added.
std::vector<Sample> speeds(const Series& x, const Series& y, double from_s, double until_s);

}  // namespace mapwright::series
