// Which maps are on screen: the submaps, the whole map, or both.
#pragma once

#include <optional>

#include "scene/map_scene.h"

namespace mapwright::window {

enum class ViewMode { Submaps, Whole, Both };

/// nullopt: neither is visible.
std::optional<ViewMode> viewMode(const scene::MapScene& scene);
/// Both: the whole map is moved below the submaps.
void setViewMode(scene::MapScene& scene, ViewMode mode);

}  // namespace mapwright::window
