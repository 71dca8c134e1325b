// Converts times of recordings between nanoseconds and seconds. Pure.
#pragma once

#include <cstdint>

namespace mapwright::recording {

/// The double nearest to the decimal value, so that printing and parsing it gives the same value.
constexpr double secondsOf(std::int64_t ns) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  return double(ns / kSecond) + double(ns % kSecond) / double(kSecond);
}

/// The shortest decimal form of this double, rounded to a nanosecond. Clamped to 63 bits; NaN is 0.
std::int64_t nanosecondsOf(double s);

}  // namespace mapwright::recording
