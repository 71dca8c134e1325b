// Converts GeoJSON to overlay features. Pure functions, any thread. Source: docs/protocols/autoxing.md,
// "Overlays"; RFC 7946.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "map/overlay.h"
#include "robot/wire/read_json.h"

namespace mapwright::robot::axbot {

/// The features of a FeatureCollection, a Feature, a list of features, or a text containing one of these, in
/// the robot's order. Undrawable ones are skipped; open rings are closed; each part of a Multi... geometry
/// becomes a feature. nullopt: it is not GeoJSON. Nothing at all (null, a blank text) has no features.
std::optional<std::vector<map::OverlayFeature>> parseOverlays(const wire::Json& overlays);
std::optional<std::vector<map::OverlayFeature>> parseOverlays(std::string_view geo_json);

}  // namespace mapwright::robot::axbot
