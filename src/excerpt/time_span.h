// A time range, as the user gave it.
#pragma once

#include <cstdint>
#include <optional>

namespace mapwright::excerpt {

/// Seconds since the epoch, both inclusive; nullopt = not given.
struct TimeSpan {
  std::optional<double> from_s, to_s;
  bool limited() const { return from_s || to_s; }
  bool holds(double at_s) const { return !(from_s && at_s < *from_s) && !(to_s && at_s > *to_s); }
};

/// Times as in MCAP: nanoseconds since 1970, clamped to the valid range.
std::int64_t nanosecondsOf(double s);
/// The first and the last nanosecond that holds() maps to `s`: several have the same seconds.
std::int64_t firstNanosecondsOf(double s);
std::int64_t lastNanosecondsOf(double s);

}  // namespace mapwright::excerpt
