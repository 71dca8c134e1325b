// Features out of a text that somebody hands in: the clipboard, another map, a text editor. Pure functions.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "overlays/overlay_document.h"

namespace mapwright::overlays {

inline constexpr std::size_t kMostPasted = 100'000;

/// Of a FeatureCollection, a list of features, one feature or a bare geometry. All of them can be used (also
/// those without a geometry), or the fault says which cannot, and why; a text that is no JSON with the place
/// of the error.
tl::expected<std::vector<Feature>, Fault> pastedFeatures(const std::string& text);

/// As they are, but for ids and names that features in `among`, or of them, have already: these become new
/// ones, and what names a feature by such an id (dockingPointId) names the new one.
std::vector<Feature> madeFree(const OverlayDocument& among, const std::vector<Feature>& features,
                              const std::function<std::string()>& new_id);

}  // namespace mapwright::overlays
