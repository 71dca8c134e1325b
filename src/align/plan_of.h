// From a whole map at its position to a plan.
#pragma once

#include <atomic>
#include <optional>

#include "align/plan.h"
#include "render/sample_grid.h"

namespace mapwright::align {

inline constexpr double kFinestCell_m = 0.05;
/// Cells of at least kFinestCell_m that are no finer than those of both maps, larger where a map would have
/// more than 6,000 along a side.
double cellsFor(const render::PlacedGrid& one, const render::PlacedGrid& other);

/// Cells known with 50 percent or more are walls, other known ones free; where a cell of the plan covers
/// several, a wall wins. 0 x 0 for a map whose numbers are unusable. nullopt: cancelled.
std::optional<Plan> planOf(const render::PlacedGrid& map, double resolution_m,
                           const std::atomic<bool>* cancelled = nullptr);

/// The same map, carried along by a transform.
render::PlacedGrid moved(const render::PlacedGrid& map, const geometry::Pose2& by);

}  // namespace mapwright::align
