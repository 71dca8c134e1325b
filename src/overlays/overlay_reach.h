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
/// place within the radius and half a metre counts, if no wall and no forbidden region lies between. Maps of
/// more than kMostCells cells are looked at in coarser cells.
std::vector<std::size_t> unreachable(const OverlayDocument& document, const placing::PlacedMap& map,
                                     double radius_m);
inline constexpr std::int64_t kMostCells = std::int64_t(64) << 20;

/// Where a robot would go from the nearest charger to a point.
struct Way {
  std::vector<Eigen::Vector2d> open;     // as far as it comes, world metres
  std::vector<Eigen::Vector2d> blocked;  // on to the point from there; empty: it gets there
};
/// The way that is blocked the least, through narrow places and overlays rather than through walls of the
/// map. nullopt: there is no charger, no map or no such point. As slow as unreachable(), and a second more.
std::optional<Way> wayTo(std::size_t feature, const OverlayDocument& document, const placing::PlacedMap& map,
                         double radius_m);

}  // namespace mapwright::overlays
