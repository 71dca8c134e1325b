// What would be done to waypoints, for people and programs, before anything is sent.
#pragma once

#include "app/waypoint_list.h"
#include "app/waypoint_plan.h"

namespace mapwright::app {

/// {"changes","calls","conflicts"}, or a table.
void printPreview(const ListedWaypoints& list, const MergedEdits& edits, bool json);
/// The requests that the store would be sent.
QJsonArray callsOf(const ListedWaypoints& list, const std::vector<WaypointEdit>& edits);

}  // namespace mapwright::app
