// A waypoint that was changed here and elsewhere, decided where it lies: mine, theirs, or both. GUI thread.
#pragma once

#include <functional>
#include <optional>

#include "edit/waypoint_fields.h"

class QMenu;

namespace mapwright::window {

class WaypointEditing;

enum class ConflictChoice {
  Mine,
  Theirs,
  Both,  // theirs stays what it is, mine becomes another one with a name of its own
};

/// The conflict of which mine or theirs lies nearest to the hand, within `reach_m`.
std::optional<edit::Key> conflictAt(const edit::WaypointDocument& document, const Eigen::Vector2d& world_m,
                                    double reach_m);
/// Both is nothing where one of them is deleted.
bool mayKeepBoth(const edit::Conflict<map::Waypoint>& conflict);
/// What it is about, and the choices.
void fillConflictMenu(QMenu& menu, const edit::WaypointDocument& document, const edit::Key& key,
                      const std::function<void(ConflictChoice)>& decided);
/// Ends the conflict. Theirs, and what becomes of mine then, can be undone.
void decideConflict(WaypointEditing& editing, const edit::Key& key, ConflictChoice choice);

}  // namespace mapwright::window
