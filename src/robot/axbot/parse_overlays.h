// From GeoJSON to overlay features. Pure functions, any thread. Source: docs/protocols/autoxing.md,
// "Overlays"; RFC 7946.
#pragma once

#include <string_view>
#include <vector>

#include "map/overlay.h"
#include "robot/wire/read_json.h"

namespace mapwright::robot::axbot {

/// The features of a FeatureCollection, a Feature, or a text that holds one, in the robot's order. What
/// cannot be drawn is left out; open rings are closed; each part of a Multi... geometry is a feature of its
/// own.
std::vector<map::OverlayFeature> parseOverlays(const wire::Json& overlays);
std::vector<map::OverlayFeature> parseOverlays(std::string_view geo_json);

/// False for a text, or something else, that says anything but is no GeoJSON at all.
bool readableOverlays(const wire::Json& overlays);

}  // namespace mapwright::robot::axbot
