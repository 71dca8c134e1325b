// Whether the robot is in a map: only there its position, and what it sees, mean anything.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "map/catalogue.h"
#include "map/live_state.h"

namespace mapwright::map {

enum class Whereabouts { Here, Elsewhere, Unknown };

/// Whether the robot is in the map `key`, called `name` where the catalogue does not have it. What the robot
/// sends about its map goes first, then the mark in the catalogue; a robot that tells neither is Unknown. One
/// that `maps_afresh` is in no stored map. A local file may be anything: Here by its name, else Unknown.
Whereabouts whereabouts(const MapKey& key, const std::string& name, const LiveState& live,
                        const std::vector<CatalogueEntry>& catalogue, bool maps_afresh);

/// The name of the map that the robot works with; empty when it is not known or has none.
std::string currentMapName(const LiveState& live, const std::vector<CatalogueEntry>& catalogue);

/// It makes a new map, in a frame of its own: nothing of a stored map belongs there. `of_stored`: whether its
/// submaps come from a stored map, that it carries on; nullopt = there are none yet, so nothing can be told.
bool mapsAfresh(const LiveState& live, std::optional<bool> of_stored);

}  // namespace mapwright::map
