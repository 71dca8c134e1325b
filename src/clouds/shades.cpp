#include "clouds/shades.h"

#include <cmath>

namespace mapwright::clouds {
namespace {

// Viridis with a lighter dark end: low points must not vanish on a dark map.
constexpr std::array<std::array<double, 3>, 6> kStops{
    {{76, 60, 160}, {58, 110, 190}, {32, 150, 150}, {70, 185, 90}, {190, 200, 40}, {250, 130, 30}}};

Shades make() {
  Shades made{};
  for (std::size_t i = 0; i < made.size(); ++i) {
    const double at = double(i) / double(made.size() - 1) * double(kStops.size() - 1);
    const auto below = std::size_t(std::min(at, double(kStops.size() - 2)));
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const double from = kStops[below][channel], to = kStops[below + 1][channel];
      made[i] = made[i] << 8 | std::uint32_t(std::lround(from + (to - from) * (at - double(below))));
    }
  }
  return made;
}

}  // namespace

const Shades& shades() {
  static const Shades made = make();
  return made;
}

}  // namespace mapwright::clouds
