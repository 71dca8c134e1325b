#include "recording/seconds.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace mapwright::recording {
namespace {

constexpr double kMostS = 9.2e9;  // the maximum for nanoseconds in 63 bits
constexpr int kDigits = 9;        // of nanoseconds

}  // namespace

std::int64_t nanosecondsOf(double s) {
  const double within = std::clamp(std::isnan(s) ? 0 : s, -kMostS, kMostS);
  std::array<char, 400> text{};  // of the smallest double
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), std::abs(within), std::chars_format::fixed).ptr;
  const std::string_view digits(text.data(), std::size_t(end - text.data()));
  const std::size_t point = std::min(digits.find('.'), digits.size());
  std::int64_t ns = 0;
  for (const char digit : digits.substr(0, point)) ns = ns * 10 + (digit - '0');
  for (std::size_t place = 1; place <= kDigits; ++place) {
    const bool there = point + place < digits.size();
    ns = ns * 10 + (there ? digits[point + place] - '0' : 0);
  }
  const std::size_t next = point + kDigits + 1;
  if (next < digits.size() && digits[next] >= '5') ++ns;
  return within < 0 ? -ns : ns;
}

}  // namespace mapwright::recording
