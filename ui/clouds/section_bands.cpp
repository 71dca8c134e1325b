#include "ui/clouds/section_bands.h"

#include <algorithm>
#include <cmath>

namespace mapwright::window {
namespace {

constexpr double kThinnestBandM = 0.05;

}  // namespace

std::optional<BandEdge> edgeNear(const std::vector<SectionBand>& bands, double height_m, double reach_m) {
  std::optional<BandEdge> best;
  double nearest = reach_m;
  bool best_is_chosen = false;
  for (std::size_t i = 0; i < bands.size(); ++i) {
    if (!bands[i].movable) continue;
    for (const bool low : {false, true}) {
      const double away = std::abs(height_m - (low ? bands[i].low_m : bands[i].high_m));
      if (away > reach_m || (best_is_chosen && !bands[i].chosen)) continue;
      if (best && best_is_chosen == bands[i].chosen && away >= nearest) continue;
      best = BandEdge{i, low};
      nearest = away;
      best_is_chosen = bands[i].chosen;
    }
  }
  return best;
}

SectionBand withEdgeAt(SectionBand band, bool low, double height_m) {
  if (low) {
    band.low_m = std::min(height_m, band.high_m - kThinnestBandM);
  } else {
    band.high_m = std::max(height_m, band.low_m + kThinnestBandM);
  }
  return band;
}

}  // namespace mapwright::window
