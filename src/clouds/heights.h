// How many points lie at which height. Pure.
#pragma once

#include <cstdint>
#include <vector>

#include "clouds/newest_clouds.h"

namespace mapwright::clouds {

/// Of the points that are shown, at any height.
struct Heights {
  double low_m = 0, high_m = 0;              // of all of them, to the point
  double usual_low_m = 0, usual_high_m = 0;  // without the outermost thousandth on each side
  std::vector<std::uint64_t>
      bins;  // of equal size from usual_low_m to usual_high_m; the outermost include everything outside
  std::uint64_t points = 0;  // if 0, nothing else is valid
};

inline constexpr int kHeightBins = 128;
Heights heightsOf(const CloudSet& set, int bins = kHeightBins);

}  // namespace mapwright::clouds
