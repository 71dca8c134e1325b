// What people are told about a thing on the map: what its layer says, where it is, and how old that is. Pure.
#pragma once

#include <optional>
#include <vector>

#include <QDateTime>
#include <QString>

#include "grids/cell_counts.h"
#include "session/session.h"
#include "ui/scene/map_object.h"

namespace mapwright::ui {

/// All that is known, the most important first. `now` is the time of day; in a replay the time of the bag is
/// taken instead. `counts`: of the cells of a whole map.
std::vector<scene::ObjectProperty> factsOf(const scene::MapObject& object, const session::Session& session,
                                           const QDateTime& now,
                                           const std::optional<grids::CellCounts>& counts = {});
/// "Automatic door Gate 3"; its kind alone if it has no name.
QString calledInFull(const scene::MapObject& object);
/// The same with all facts, a line each, for the clipboard.
QString asText(const scene::MapObject& object, const std::vector<scene::ObjectProperty>& facts);

}  // namespace mapwright::ui
