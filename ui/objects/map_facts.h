// What is known of a whole map on screen. Pure.
#pragma once

#include <optional>
#include <vector>

#include "grids/cell_counts.h"
#include "session/session.h"
#include "ui/scene/map_object.h"

namespace mapwright::ui {

/// `counts`: of its cells, once they are counted.
std::vector<scene::ObjectProperty> mapFacts(const session::MapSlot& slot, const session::Session& session,
                                            const std::optional<grids::CellCounts>& counts);

}  // namespace mapwright::ui
