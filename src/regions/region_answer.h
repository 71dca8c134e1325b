// Where an answer lies, next to what was asked for. Pure functions.
#pragma once

#include <optional>
#include <vector>

#include "geometry/rect.h"
#include "map/grid_reference.h"

namespace mapwright::regions {

/// Of another place: it does not overlap `asked` at all, or is as large, but lies beside it in part. One that
/// is cut, padded or larger is of this place.
bool liesElsewhere(const map::GridReference& answer, const geometry::WorldRect& asked);

/// For an answer that lies elsewhere by half of its lengths, as of a dispatcher that takes the middle of what
/// it is asked for as a corner: the lengths to ask for beside it. nullopt: it lies elsewhere in another way.
std::optional<Eigen::Vector2d> aimAgainst(const map::GridReference& answer, const geometry::WorldRect& asked);

/// What both have; empty for an answer that is turned.
geometry::WorldRect commonGround(const map::GridReference& answer, const geometry::WorldRect& asked);

/// `rect` without `others`, in pieces that do not overlap.
std::vector<geometry::WorldRect> without(const geometry::WorldRect& rect,
                                         const std::vector<geometry::WorldRect>& others);

}  // namespace mapwright::regions
