// The waypoints of one map of a robot, as read by a command, and looking one up.
#pragma once

#include <string>

#include "app/maps_command.h"
#include "app/waypoints.h"
#include "exchange/waypoint_plan.h"
#include "robot/waypoint_store.h"

namespace mapwright::app {

struct ListedWaypoints {
  MapReading* robot = nullptr;  // not null
  map::MapKey map;
  robot::StoredWaypoints stored = {};
  robot::WaypointStore* store = nullptr;  // null = read-only

  std::string mapId() const { return map::toText(map); }
  /// A failed request about them.
  CommandFailure failure(const map::Failure& failed) const;
};

/// The edits as they will be stored; notes what cannot be.
std::vector<exchange::WaypointEdit> fitted(const ListedWaypoints& list,
                                           std::vector<exchange::WaypointEdit> edits);

enum class Use { Reading, Changing };
/// Connects and reads the waypoints of the map `map` ("" = the current one). With Changing, a robot without a
/// WaypointStore is refused.
CommandResult<ListedWaypoints> listWaypoints(MapsCommand& command, const WaypointsWords& words,
                                             const std::string& map, Use use);

/// Finds a waypoint by its id, or by its name if only one has it.
CommandResult<const map::Waypoint*> chosen(const ListedWaypoints& list, const std::string& word);

/// Common to every command: its time limit, its report, its one line on standard error.
int runWaypointsCommand(const WaypointsWords& words, int& argc, char** argv,
                        const std::function<CommandResult<int>(MapsCommand&)>& work);

/// On the standard output.

}  // namespace mapwright::app
