// Which services of KABAM's MapManagerV2 a change of waypoints takes, in an order in which no name is ever
// used twice. Pure. Source: docs/protocols/kabam-map-manager.md, "Services".
#pragma once

#include <vector>

#include "robot/waypoint_store.h"

namespace mapwright::robot::ros {

enum class WaypointService { Create, Rename, Reposition, Delete };

/// The service that makes this change; of one that plan() made it makes all of it.
WaypointService serviceOf(const WaypointChange& change);

/// "create_waypoint"
const char* nameOf(WaypointService service);

/// One request for each service call, the least number of them: what goes, then the names (two that are
/// exchanged by way of a name that nobody has), what is new, then the places. Tags travel with the last call
/// of their waypoint.
std::vector<WaypointRequest> planWaypoints(const StoredWaypoints& now,
                                           const std::vector<WaypointChange>& changes);

}  // namespace mapwright::robot::ros
