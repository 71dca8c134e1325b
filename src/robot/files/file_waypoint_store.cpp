#include "robot/files/file_waypoint_store.h"

namespace mapwright::robot::files {

FileWaypointStore::FileWaypointStore(WaypointFiles* files) : files_(files) {
  connect(files, &WaypointFiles::changed, this, &WaypointStore::changed);
}

Call FileWaypointStore::read(const map::MapKey& key, OutcomeTo<StoredWaypoints> reply) {
  return files_.ask(map::placesOf(key), std::move(reply), &WaypointFiles::read, key);
}

std::vector<WaypointRequest> FileWaypointStore::plan(const StoredWaypoints& now,
                                                     const std::vector<WaypointChange>& changes) const {
  if (changes.empty()) return {};
  return {WaypointRequest{changes, now.revision}};
}

// Disk operations cannot be undone: even if cancelled, it reports the real result.
Call FileWaypointStore::perform(const map::MapKey& key, const WaypointRequest& request,
                                OutcomeTo<WaypointReceipt> reply) {
  return files_.change(map::placesOf(key), std::move(reply), &WaypointFiles::write, key, request);
}

}  // namespace mapwright::robot::files

#include "moc_file_waypoint_store.cpp"
