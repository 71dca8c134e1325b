// Whether one of two aligned maps is bent: how they differ smoothly when the best rigid transform has done
// what it can. Pure functions.
#pragma once

#include "align/fit.h"

namespace mapwright::align {

struct Bend {
  double off_m = 0;  // how far a place is off when another one is laid exactly, its heading too: 95 % less
  double gain = 0;   // how many more walls agree within kExact_m when the map is bent back: share of all
  static constexpr double kExact_m = 0.04;
};
/// Nothing if hardly any walls agree.
Bend bendOf(const Sheets& sheets, const Points& points, const geometry::Pose2& pose);

}  // namespace mapwright::align
