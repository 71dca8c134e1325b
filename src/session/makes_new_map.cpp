#include "session/makes_new_map.h"

#include <optional>

#include "map/live_state.h"
#include "map/whereabouts.h"
#include "robot/map_administration.h"
#include "robot/robot.h"
#include "submap/submap_store.h"

namespace mapwright::session {

bool makesNewMap(robot::Robot& robot, const map::LiveState& live, const submap::SubmapStore& submaps) {
  using robot::MapChange;
  std::optional<bool> of_stored;  // nullopt: there are none yet
  if (submaps.listReceived() && !submaps.rows().empty()) of_stored = submaps.frozenCount() > 0;
  if (map::mapsAfresh(live, of_stored)) return true;
  // What cannot extend a map makes a new one whenever it is mapping.
  const robot::MapAdministration* const robots = robot.mapAdministration();
  return robots && robots->obstacle(MapChange::ContinueMapping, nullptr) == robot::Obstacle::NotOffered &&
         robots->obstacle(MapChange::StartMapping, nullptr) == robot::Obstacle::WhileMapping;
}

}  // namespace mapwright::session
