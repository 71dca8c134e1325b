// Resolves the conflict of a waypoint on the map: mine, theirs, or both. GUI thread.
#pragma once

#include <functional>
#include <optional>

#include "edit/document.h"

class QMenu;

namespace mapwright::window {

class WaypointEditing;

enum class ConflictChoice {
  Mine,
  Theirs,
  Both,  // theirs stays, and mine becomes another one with its own name
};

/// The conflict whose version (mine or theirs) is nearest to the cursor, within `reach_m`.
std::optional<edit::Key> conflictAt(const edit::WaypointDocument& document, const Eigen::Vector2d& world_m,
                                    double reach_m);
/// Impossible if one of them is deleted.
bool mayKeepBoth(const edit::Conflict& conflict);
/// Its description and the choices.
void fillConflictMenu(QMenu& menu, const edit::WaypointDocument& document, const edit::Key& key,
                      const std::function<void(ConflictChoice)>& decided);
/// Ends the conflict. Taking theirs, with its effect on mine, can be undone.
void decideConflict(WaypointEditing& editing, const edit::Key& key, ConflictChoice choice);

}  // namespace mapwright::window
