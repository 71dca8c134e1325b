// The spacing of the metric grid.
#pragma once

#include "geometry/view_transform.h"

namespace mapwright::scene {

struct GridSteps {
  double minor_m, major_m;
};
/// 1, 2 or 5 times a power of ten, so that lines keep their distance on screen; major lines are at round
/// numbers.
GridSteps gridSteps(const geometry::ViewTransform& view);

}  // namespace mapwright::scene
