// Numbers that read back as the same ones, for files.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace mapwright::words {

/// The shortest such text: "400000", not "4e+05". Only numbers that no length and no time has (from 1e15 on,
/// and below a millionth) have an exponent.
inline std::string shortest(double number) {
  const double size = std::abs(number);
  const bool plain = size == 0 || (size >= 1e-6 && size < 1e15);
  std::array<char, 64> digits{};
  char* const last = digits.data() + digits.size();
  const auto written = plain ? std::to_chars(digits.data(), last, number, std::chars_format::fixed)
                             : std::to_chars(digits.data(), last, number);
  return {digits.data(), written.ptr};
}

}  // namespace mapwright::words
