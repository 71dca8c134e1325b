// Converts GeoJSON to overlay features. Pure functions, any thread. Source: docs/protocols/autoxing.md,
// "Overlays"; RFC 7946.
#pragma once

#include <string_view>
#include <vector>

#include "map/overlay.h"
#include "robot/wire/read_json.h"

namespace mapwright::robot::axbot {

/// The features of a FeatureCollection, a Feature, or a text containing one, in the robot's order. Undrawable
/// ones are skipped; open rings are closed; each part of a Multi... geometry becomes a feature.
std::vector<map::OverlayFeature> parseOverlays(const wire::Json& overlays);
std::vector<map::OverlayFeature> parseOverlays(std::string_view geo_json);

/// False for a non-empty value that is not GeoJSON.
bool readableOverlays(const wire::Json& overlays);

}  // namespace mapwright::robot::axbot
