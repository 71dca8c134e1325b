// Features as the map draws them. Pure functions.
#pragma once

#include <optional>
#include <vector>

#include "map/overlay.h"
#include "overlays/overlay_document.h"

namespace mapwright::overlays {

/// Several for a shape of several parts, none for one without a place.
std::vector<map::OverlayFeature> partsToDraw(const Feature& feature);
/// nullopt: all of it is drawn, or it has no place, which is allowed.
std::optional<map::BrokenOverlay> notDrawn(const Feature& feature);

}  // namespace mapwright::overlays
