#include "robot/wire/forwarded.h"

namespace mapwright::robot::wire {

Call WaypointsOfStore::waypoints(const map::MapKey& key, OutcomeTo<map::WaypointList> reply) {
  return store_.read(key, [reply = std::move(reply)](Outcome<StoredWaypoints> stored) {
    if (!stored) return reply(fail(std::move(stored.error())));
    reply(map::WaypointList{std::move(stored->points), std::move(stored->notes)});
  });
}

}  // namespace mapwright::robot::wire
