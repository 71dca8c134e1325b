// How far apart the lines of the metric grid are.
#pragma once

#include "geometry/view_transform.h"

namespace mapwright::scene {

struct GridSteps {
  double minor_m, major_m;
};
/// 1, 2 or 5 times a power of ten, so that lines keep a distance on screen; major lines fall on round
/// numbers.
GridSteps gridSteps(const geometry::ViewTransform& view);

}  // namespace mapwright::scene
