// Features as the map draws them. Pure functions.
#pragma once

#include <vector>

#include "map/overlay.h"
#include "overlays/overlay_document.h"

namespace mapwright::overlays {

/// Several for a shape of several parts, none for one without a place.
std::vector<map::OverlayFeature> partsToDraw(const Feature& feature);

}  // namespace mapwright::overlays
