#include "excerpt/time_span.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "recording/message.h"

namespace mapwright::excerpt {
namespace {

/// Near `about`, the approximate limit: from there on `holds` is true.
template <typename Holds>
std::int64_t firstWhere(std::int64_t about, double s, Holds holds) {
  const auto apart = std::int64_t((std::nextafter(s, HUGE_VAL) - s) * 1e9) + 2;
  std::int64_t low = std::max<std::int64_t>(0, about - apart), high = about + apart;
  while (low < high) {
    const std::int64_t middle = low + (high - low) / 2;
    if (holds(middle)) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return low;
}

}  // namespace

std::int64_t nanosecondsOf(double s) {
  constexpr double kMost = double(std::numeric_limits<std::int64_t>::max()) / 1e9;
  if (!(s > 0)) return 0;
  if (s >= kMost) return std::numeric_limits<std::int64_t>::max();
  return recording::nanosecondsOf(s);
}

std::int64_t firstNanosecondsOf(double s) {
  const std::int64_t about = nanosecondsOf(s);
  if (about == 0 || about == std::numeric_limits<std::int64_t>::max()) return about;
  return firstWhere(about, s, [s](std::int64_t ns) { return recording::secondsOf(ns) >= s; });
}

std::int64_t lastNanosecondsOf(double s) {
  const std::int64_t about = nanosecondsOf(s);
  if (about == 0 || about == std::numeric_limits<std::int64_t>::max()) return about;
  return firstWhere(about, s, [s](std::int64_t ns) { return recording::secondsOf(ns) > s; }) - 1;
}

}  // namespace mapwright::excerpt
