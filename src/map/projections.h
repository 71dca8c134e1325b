// What of a map in space is laid on the plane, as lists: which make sense, and which are alike. Pure.
// Source: docs/protocols/rep130-map-dispatcher.md, "Projections".
#pragma once

#include <vector>

#include "map/map_part.h"

namespace mapwright::map {

/// Why a robot would not be told of a projection.
enum class ProjectionFlaw { None, NotFinite, TooFar, WithoutSize, HeightsCrossed };
ProjectionFlaw flawOf(const Projection& projection);

/// How many of `told` are not what was `wanted`, by more than grids of cells make of it; those that are
/// missing or too many count as well.
int differing(const std::vector<Projection>& wanted, const std::vector<Projection>& told);

}  // namespace mapwright::map
