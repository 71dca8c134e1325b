// Aligning maps at their positions: the same for the command and the window.
#pragma once

#include <atomic>
#include <optional>

#include "align/align.h"
#include "render/sample_grid.h"

namespace mapwright::align {

/// Where `old_map` lies on `new_map`, from its own position. Blocks; not on a thread of the pool. nullopt:
/// cancelled, by `cancelled` or by `options.proceed`.
std::optional<Alignment> alignPlaced(const render::PlacedGrid& old_map, const render::PlacedGrid& new_map,
                                     const Options& options, const std::atomic<bool>* cancelled = nullptr);

}  // namespace mapwright::align
