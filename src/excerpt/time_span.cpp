#include "excerpt/time_span.h"

#include <limits>

#include "recording/seconds.h"

namespace mapwright::excerpt {

std::int64_t nanosecondsOf(double s) {
  constexpr double kMost = double(std::numeric_limits<std::int64_t>::max()) / 1e9;
  if (!(s > 0)) return 0;
  if (s >= kMost) return std::numeric_limits<std::int64_t>::max();
  return recording::nanosecondsOf(s);
}

}  // namespace mapwright::excerpt
