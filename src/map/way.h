// Whether to draw a line between two consecutive positions of the robot. Pure.
#pragma once

#include "map/live_state.h"

namespace mapwright::map {

/// A robot that appears to be faster was moved: its position jumped.
constexpr double kJumpM = 0.5, kJumpMPerS = 5;
bool isJump(const TrailPoint& before, const TrailPoint& after);

/// After such a pause and distance the robot may have taken any path.
constexpr double kUnheardM = 1, kUnheardS = 5;
/// No jump and no long pause.
bool isWayKnown(const TrailPoint& before, const TrailPoint& after);

}  // namespace mapwright::map
