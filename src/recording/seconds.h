// Times of recordings, which are whole nanoseconds, as seconds and back. Pure.
#pragma once

#include <cstdint>

namespace mapwright::recording {

/// The double next to what its digits say: one that was printed and typed again is the same.
constexpr double secondsOf(std::int64_t ns) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  return double(ns / kSecond) + double(ns % kSecond) / double(kSecond);
}

/// What the shortest digits that mean this double say, to the next nanosecond. Beyond what 63 bits hold the
/// outermost; no number is 0.
std::int64_t nanosecondsOf(double s);

}  // namespace mapwright::recording
