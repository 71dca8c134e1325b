// Round lengths for the grid and the scale bar.
#pragma once

#include <QString>

#include "geometry/view_transform.h"

namespace mapwright::ui::scene {

/// The spacing of the metric grid.
struct GridSteps {
  double minor_m, major_m;
};
/// 1, 2 or 5 times a power of ten, so that lines keep their distance on screen; major lines are at round
/// numbers.
GridSteps gridSteps(const geometry::ViewTransform& view);
/// The largest of 1, 2 or 5 times a power of ten that is not above `value`.
double roundDown125(double value);
/// "250 mm", "5 m", "1.2 km"; "?" if it is no number.
QString lengthText(double metres);
/// "3.5 m²", "1.2 km²".
QString areaText(double m2);

}  // namespace mapwright::ui::scene
