// Where an answer is, relative to the request. Pure functions.
#pragma once

#include <optional>
#include <vector>

#include "geometry/rect.h"
#include "map/grid_reference.h"

namespace mapwright::regions {

/// True if it is elsewhere: it does not overlap `asked` at all, or has the same size but is displaced.
/// Clipped, padded or larger answers are not elsewhere.
bool liesElsewhere(const map::GridReference& answer, const geometry::WorldRect& asked);

/// For an answer displaced by half its size, as from a dispatcher that takes the requested centre as a
/// corner: the offset to add to requests. nullopt: it is displaced in another way.
std::optional<Eigen::Vector2d> aimAgainst(const map::GridReference& answer, const geometry::WorldRect& asked);

/// The overlap; empty for a rotated answer.
geometry::WorldRect commonGround(const map::GridReference& answer, const geometry::WorldRect& asked);

/// `rect` without `others`, in pieces that do not overlap.
std::vector<geometry::WorldRect> without(const geometry::WorldRect& rect,
                                         const std::vector<geometry::WorldRect>& others);

}  // namespace mapwright::regions
