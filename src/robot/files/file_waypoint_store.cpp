#include "robot/files/file_waypoint_store.h"

namespace mapwright::robot::files {

FileWaypointStore::FileWaypointStore(WaypointFiles* files, QObject* parent)
    : WaypointStore(parent), files_(files) {
  connect(files_, &WaypointFiles::changed, this, &WaypointStore::changed);
}

Call FileWaypointStore::read(const map::MapKey& key, OutcomeTo<StoredWaypoints> reply) {
  return wire::askAcross(this, files_, reads_, map::placesOf(key, {}), std::move(reply),
                         [key](WaypointFiles& files, const auto&, auto answer) { answer(files.read(key)); });
}

Call FileWaypoints::waypoints(const map::MapKey& key, OutcomeTo<map::WaypointList> reply) {
  return wire::askAcross(asker_, files_, reads_, map::placesOf(key, {}), std::move(reply),
                         [key](WaypointFiles& files, const auto&, auto answer) {
                           Outcome<StoredWaypoints> stored = files.read(key);
                           if (!stored) return answer(tl::make_unexpected(std::move(stored.error())));
                           answer(map::WaypointList{std::move(stored->points), std::move(stored->notes)});
                         });
}

std::vector<WaypointRequest> FileWaypointStore::plan(const StoredWaypoints& now,
                                                     const std::vector<WaypointChange>& changes) const {
  if (changes.empty()) return {};
  return {WaypointRequest{changes, now.revision}};
}

// Disk operations cannot be undone: even if cancelled, it reports the real result.
Call FileWaypointStore::perform(const map::MapKey& key, const WaypointRequest& request,
                                OutcomeTo<WaypointReceipt> reply) {
  return wire::askAcross(
      this, files_, changes_, map::placesOf(key, {}), std::move(reply),
      [key, request](WaypointFiles& files, const auto&, auto answer) { answer(files.write(key, request)); },
      wire::Stopping::AsItStands);
}

}  // namespace mapwright::robot::files

#include "moc_file_waypoint_store.cpp"
