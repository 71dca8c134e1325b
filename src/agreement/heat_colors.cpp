#include "agreement/heat_colors.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace mapwright::agreement {

Argb contradictionColor(std::uint64_t cells_in_square, std::uint64_t full) {
  constexpr std::array<std::array<double, 3>, 4> kStops{
      {{255, 214, 64}, {255, 140, 26}, {230, 50, 30}, {140, 0, 20}}};
  const double share =
      full <= 1
          ? 1
          : std::clamp(std::log(double(std::max<std::uint64_t>(cells_in_square, 1))) / std::log(double(full)),
                       0.0, 1.0);
  const double at = share * (kStops.size() - 1);
  const std::size_t below = std::min(std::size_t(at), kStops.size() - 2);
  Argb color = 0xff;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const double from = kStops[below][channel], to = kStops[below + 1][channel];
    color = color << 8 | Argb(std::lround(from + (to - from) * (at - double(below))));
  }
  return color;
}

Argb coverageColor(int seen_by) {
  constexpr std::array<Argb, 5> kSteps{0xffc6dbef, 0xff9ecae1, 0xff6baed6, 0xff3182bd, 0xff08519c};
  if (seen_by <= 0) return kUnseen;
  if (seen_by == 1) return kSeenOnce;
  return kSteps[std::min(std::size_t(std::bit_width(unsigned(seen_by))) - 2, kSteps.size() - 1)];
}

bool isHatched(std::int64_t column, std::int64_t row) { return ((column + row) & 3) == 0; }

}  // namespace mapwright::agreement
