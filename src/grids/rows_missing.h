// How much of a map its picture does not hold. Any thread.
#pragma once

#include "grids/grid_pyramid.h"

namespace mapwright::grids {

/// How many rows of level 0 never came because the source ended early: they are unknown. Known once the
/// pyramid is complete; 0 for other kinds of pyramids.
int rowsMissing(const GridPyramid& cells);

}  // namespace mapwright::grids
