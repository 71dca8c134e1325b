// Aligns a map with what is on screen: with another whole map, or with submaps, which are composed first.
#pragma once

#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include <tl/expected.hpp>

#include "align/align.h"
#include "fault/fault.h"
#include "placing/align.h"
#include "render/compositor.h"
#include "render/sample_grid.h"
#include "ui/kit/background_run.h"
#include "work/workers.h"

namespace mapwright::ui {

/// Submaps are in ascending order of their ids.
using OnScreen = std::variant<render::PlacedGrid, std::vector<render::PlacedTexture>>;

/// Where `old_map` lies on `new_map`. Blocks. nullopt: cancelled. The error: the submaps cannot be composed.
tl::expected<std::optional<align::Alignment>, Fault> alignOnScreen(
    const render::PlacedGrid& old_map, const OnScreen& new_map, const std::vector<placing::PointPair>& pairs,
    const std::shared_ptr<work::Workers>& workers, const BackgroundRun::Running& run);

}  // namespace mapwright::ui
