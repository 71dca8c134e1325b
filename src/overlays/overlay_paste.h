// Features out of a text that somebody hands in: the clipboard, another map, a text editor. Pure functions.
#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "overlays/overlay_document.h"

namespace mapwright::overlays {

inline constexpr std::size_t kMostPasted = 100'000;

/// Of a FeatureCollection, a list of features, one feature or a bare geometry. All of them can be used, or
/// the fault says which cannot, and why; a text that is no JSON with the place of the error.
tl::expected<std::vector<Feature>, Fault> pastedFeatures(const std::string& text);

}  // namespace mapwright::overlays
