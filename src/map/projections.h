// Lists of projections: which are valid, and which are equal. Pure. Source:
// docs/protocols/rep130-map-dispatcher.md, "Projections".
#pragma once

#include <vector>

#include "map/map_part.h"

namespace mapwright::map {

/// Why a projection would not be sent to a robot.
enum class ProjectionFlaw { None, NotFinite, TooFar, WithoutSize, HeightsCrossed };
ProjectionFlaw flawOf(const Projection& projection);

/// How many of `told` differ from `wanted` by more than rounding to grid cells; missing and extra ones count
/// as well.
int differing(const std::vector<Projection>& wanted, const std::vector<Projection>& told);

}  // namespace mapwright::map
