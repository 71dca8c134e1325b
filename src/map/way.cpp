#include "map/way.h"

#include <algorithm>

namespace mapwright::map {

bool isJump(const TrailPoint& before, const TrailPoint& after) {
  const double way_m = (after.position_m - before.position_m).norm();
  return way_m > kJumpM && way_m > kJumpMPerS * std::max(after.at_s - before.at_s, 0.0);
}

bool isWayKnown(const TrailPoint& before, const TrailPoint& after) {
  const bool unheard =
      after.at_s - before.at_s > kUnheardS && (after.position_m - before.position_m).norm() > kUnheardM;
  return !unheard && !isJump(before, after);
}

}  // namespace mapwright::map
