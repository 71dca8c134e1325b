#include "excerpt/time_span.h"

#include <cmath>
#include <limits>

namespace mapwright::excerpt {

std::int64_t nanosecondsOf(double s) {
  constexpr double kNsPerS = 1e9;
  constexpr double kMost = double(std::numeric_limits<std::int64_t>::max()) / kNsPerS;
  if (!(s > 0)) return 0;
  if (s >= kMost) return std::numeric_limits<std::int64_t>::max();
  // The whole seconds apart: a double of nanoseconds would be off by hundreds of them.
  const double whole = std::floor(s);
  return std::int64_t(whole) * 1'000'000'000 + std::llround((s - whole) * kNsPerS);
}

}  // namespace mapwright::excerpt
