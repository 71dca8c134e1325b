// Random numbers as pure functions: the same seed gives the same robot in every run.
#pragma once

#include <cstdint>
#include <string>

namespace mapwright::simulator {

/// A well mixed 64-bit value of `x` (the finaliser of SplitMix64).
constexpr std::uint64_t mix(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15ULL;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
  return x ^ (x >> 31);
}

/// One value that depends on all of `values` and on their order.
template <typename... Values>
constexpr std::uint64_t hashOf(Values... values) {
  std::uint64_t h = 0x51ED270B9F1C2A37ULL;
  ((h = mix(h ^ static_cast<std::uint64_t>(values))), ...);
  return h;
}

/// `h` as a number in [0, 1).
constexpr double unitFrom(std::uint64_t h) { return static_cast<double>(h >> 11) * 0x1.0p-53; }

/// A random sequence with a seed.
class Dice {
 public:
  explicit constexpr Dice(std::uint64_t seed) : state_(mix(seed)) {}

  constexpr std::uint64_t next() {
    state_ += 0x9E3779B97F4A7C15ULL;
    return mix(state_);
  }
  constexpr double uniform(double low, double high) { return low + (high - low) * unitFrom(next()); }
  constexpr bool chance(double probability) { return unitFrom(next()) < probability; }
  /// A whole number in [low, high].
  constexpr int integer(int low, int high) {
    return low + static_cast<int>(next() % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::uint64_t state_;
};

/// So many random hexadecimal digits.
inline std::string hexDigits(std::uint64_t seed, int count) {
  std::string digits;
  Dice dice(seed);
  for (int i = 0; i < count; ++i) digits += "0123456789abcdef"[dice.next() & 15];
  return digits;
}

}  // namespace mapwright::simulator
