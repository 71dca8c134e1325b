// Which points a robot can still reach from its chargers. Pure.
#pragma once

#include <cstddef>
#include <vector>

#include "overlays/overlay_document.h"
#include "placing/ground.h"

namespace mapwright::overlays {

/// The indices of the destinations that a circle of `radius_m` cannot reach from any charger: through the
/// free cells of the map and free regions, not across virtual walls and forbidden regions. Empty without a
/// charger on the map. Destinations and chargers stand a little off the way (against a wall): the nearest
/// place within the radius and half a metre counts. Maps of more than kMostCells cells are looked at in
/// coarser cells.
std::vector<std::size_t> unreachable(const OverlayDocument& document, const placing::PlacedMap& map,
                                     double radius_m);
inline constexpr std::int64_t kMostCells = std::int64_t(64) << 20;

}  // namespace mapwright::overlays
