// How many points lie at which height. Pure.
#pragma once

#include <cstdint>
#include <vector>

#include "clouds/cloud_book.h"

namespace mapwright::clouds {

/// Of the points that are shown, whatever their height.
struct Heights {
  double low_m = 0, high_m = 0;              // of all of them, to the point
  double usual_low_m = 0, usual_high_m = 0;  // but for the outermost thousandth on both sides
  std::vector<std::uint64_t>
      bins;                  // of equal size from usual_low_m to usual_high_m; those outside in the outermost
  std::uint64_t points = 0;  // 0: then nothing else means anything
};

inline constexpr int kHeightBins = 128;
Heights heightsOf(const CloudSet& set, int bins = kHeightBins);

}  // namespace mapwright::clouds
