// Whether a line may be drawn between two places where the robot was seen one after the other. Pure.
#pragma once

#include "map/live_state.h"

namespace mapwright::map {

/// A robot that seems to be faster was put elsewhere: its position jumped.
constexpr double kJumpM = 0.5, kJumpMPerS = 5;
bool isJump(const TrailPoint& before, const TrailPoint& after);

/// One that nobody heard of for so long, and that is so far away then, may have gone any way.
constexpr double kUnheardM = 1, kUnheardS = 5;
/// Neither a jump nor unheard of.
bool isWayKnown(const TrailPoint& before, const TrailPoint& after);

}  // namespace mapwright::map
