// From when until when, as it was asked for.
#pragma once

#include <cstdint>
#include <optional>

namespace mapwright::excerpt {

/// Seconds since the epoch, both counted in; nullopt = not given.
struct TimeSpan {
  std::optional<double> from_s, to_s;
  bool holds(double at_s) const { return !(from_s && at_s < *from_s) && !(to_s && at_s > *to_s); }
};

/// As MCAP has times: nanoseconds since 1970; what lies before or beyond becomes the first or the last.
std::int64_t nanosecondsOf(double s);
/// The first and the last of those that holds() would take for `s`: several have the same seconds.
std::int64_t firstNanosecondsOf(double s);
std::int64_t lastNanosecondsOf(double s);

}  // namespace mapwright::excerpt
