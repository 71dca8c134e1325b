// Which services of KABAM's MapManagerV2 to call for a change of waypoints, in an order in which no name is
// ever used twice. Pure. Source: docs/protocols/kabam-map-manager.md, "Services".
#pragma once

#include <vector>

#include "robot/waypoint_store.h"

namespace mapwright::robot::ros {

enum class WaypointService { Create, Rename, Reposition, Delete };

/// The service for this change; requests from plan() need no other one.
WaypointService serviceOf(const WaypointChange& change);

/// "create_waypoint"
const char* nameOf(WaypointService service);

/// The minimum number of requests, one per service call: deletions, then names (two that are swapped go
/// through an unused name), then new waypoints, then positions. Tags are sent with the last call for their
/// waypoint.
std::vector<WaypointRequest> planWaypoints(const StoredWaypoints& now,
                                           const std::vector<WaypointChange>& changes);

}  // namespace mapwright::robot::ros
