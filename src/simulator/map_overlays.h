// What is drawn over a stored map (axbot.md, "Overlays").
#pragma once

#include <string>

#include "simulator/map_library.h"

namespace mapwright::simulator {

/// A GeoJSON FeatureCollection with every kind of feature: points with a yaw as number and as text, lines,
/// regions, a ring that is left open, kinds that nobody knows. Placed along the map's own drive.
std::string overlaysOf(const Scene& scene, const StoredMap& map);

}  // namespace mapwright::simulator
