// What is drawn over a stored map (docs/protocols/autoxing.md, "Overlays").
#pragma once

#include <string>
#include <string_view>

#include "simulator/scene.h"

namespace mapwright::simulator {

/// A GeoJSON FeatureCollection with every kind of feature: points with a yaw as number and as text, lines,
/// regions, a ring that is left open, kinds that nobody knows. Placed along the drive of a trajectory.
std::string overlaysAlong(const Scene& scene, int trajectory);
/// One without any features.
std::string noOverlays();
/// Whether a text can be a map's overlays: a JSON object with a list of features, or nothing at all.
bool isOverlays(std::string_view text);

}  // namespace mapwright::simulator
