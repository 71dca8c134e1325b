// Rough places of one map on another, for all headings: correlation of coarse pictures of their walls.
#pragma once

#include <functional>
#include <vector>

#include "align/plan.h"
#include "geometry/pose.h"
#include "work/workers.h"

namespace mapwright::align {

struct RoughPlace {
  geometry::Pose2 transform;  // from old to new
  double correlation = 0;     // comparable among the places of one search
};

struct RoughSearch {
  double cell_m = 0;               // of the coarse pictures
  double step_rad = 0;             // between headings
  std::vector<RoughPlace> places;  // best first, none close to a better one
};

struct Thoroughness {
  int cells = 160;        // of the larger side of the larger map
  std::size_t most = 80;  // places
};

/// `proceed` gets the share that is done, and false cancels. Empty when
/// cancelled.
RoughSearch roughPlaces(const Plan& old_map, const Plan& new_map, const Thoroughness& how, work::Tasks& tasks,
                        const std::function<bool(double)>& proceed);

}  // namespace mapwright::align
