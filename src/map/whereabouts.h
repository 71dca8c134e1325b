// Whether the robot is in a map: only then its pose and sensor data are meaningful.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "map/catalogue.h"

namespace mapwright::map {

struct LiveState;

enum class Whereabouts { Here, Elsewhere, Unknown };

/// Whether the robot is in the map `key`, called `name` if it is not in the catalogue. The robot's map
/// messages take precedence over the mark in the catalogue; without either the result is Unknown. A robot
/// that `maps_afresh` is in no stored map. A local file may be anything: Here if the name matches, otherwise
/// Unknown.
Whereabouts whereabouts(const MapKey& key, const std::string& name, const LiveState& live,
                        const std::vector<CatalogueEntry>& catalogue, bool maps_afresh);

/// The name of the map that the robot uses; empty if it is unknown or has none.
std::string currentMapName(const LiveState& live, const std::vector<CatalogueEntry>& catalogue);

/// It is making a new map, in a frame of its own, which no stored map shares. `of_stored`: whether its
/// submaps continue a stored map; nullopt = there are none yet, so this is unknown.
bool mapsAfresh(const LiveState& live, std::optional<bool> of_stored);

}  // namespace mapwright::map
