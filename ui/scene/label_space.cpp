#include "scene/label_space.h"

#include <algorithm>
#include <cmath>

namespace mapwright::scene {
namespace {

constexpr double kBandPx = 32;

// An invalid position goes into the first band: a robot may send one.
int bandOf(double y) { return y > -1e6 ? int(std::floor(std::min(y, 1e6) / kBandPx)) : int(-1e6 / kBandPx); }

}  // namespace

bool LabelSpace::free(const QRectF& spot) const {
  for (int band = bandOf(spot.top()); band <= bandOf(spot.bottom()); ++band) {
    const auto taken = bands_.find(band);
    if (taken == bands_.end()) continue;
    for (const QRectF& other : taken->second) {
      if (other.intersects(spot)) return false;
    }
  }
  return true;
}

std::optional<QRectF> LabelSpace::take(std::span<const QRectF> spots) {
  const auto spot = std::find_if(spots.begin(), spots.end(), [this](const QRectF& s) { return free(s); });
  if (spot == spots.end()) return std::nullopt;
  for (int band = bandOf(spot->top()); band <= bandOf(spot->bottom()); ++band) bands_[band].push_back(*spot);
  return *spot;
}

}  // namespace mapwright::scene
