// The overlays of a stored map (docs/protocols/autoxing.md, "Overlays").
#pragma once

#include <string>
#include <string_view>

#include "simulator/scene.h"

namespace mapwright::simulator {

/// A GeoJSON FeatureCollection with every kind of feature: points with a yaw as number and as text, lines,
/// regions, an open ring, unknown kinds. Placed along a trajectory.
std::string overlaysAlong(const Scene& scene, int trajectory);
/// One without any features.
std::string noOverlays();
/// Whether a text is valid as a map's overlays: a JSON object with a list of features, or empty.
bool isOverlays(std::string_view text);

}  // namespace mapwright::simulator
