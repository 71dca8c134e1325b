// The waypoints of one map of a robot, as a command reads them and names one of them.
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
  robot::WaypointStore* store = nullptr;  // null = they can only be read

  std::string mapId() const { return map::toText(map); }
  /// A request about them that failed.
  CommandFailure failure(const map::Failure& failed) const;
};

/// The edits as they are going to be kept there; what of them is not is noted.
std::vector<exchange::WaypointEdit> fitted(const ListedWaypoints& list,
                                           std::vector<exchange::WaypointEdit> edits);

enum class Use { Reading, Changing };
/// Connects, and reads those of the map `map` ("" = the current one). For Changing a robot without a
/// WaypointStore is refused.
CommandResult<ListedWaypoints> listWaypoints(MapsCommand& command, const WaypointsWords& words,
                                             const std::string& map, Use use);

/// The one that is meant by `word`: its id, else its name where no other one has it.
CommandResult<const map::Waypoint*> chosen(const ListedWaypoints& list, const std::string& word);

/// The frame of every command: its time, its report, its one line on standard error.
int runWaypointsCommand(const WaypointsWords& words, int& argc, char** argv,
                        const std::function<CommandResult<int>(MapsCommand&)>& work);

/// On the standard output.

}  // namespace mapwright::app
