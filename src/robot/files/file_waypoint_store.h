// The waypoint lists of local maps behind the port.
#pragma once

#include "robot/files/waypoint_files.h"
#include "robot/waypoint_store.h"
#include "robot/wire/link_ref.h"

namespace mapwright::robot::files {

/// Nothing here accesses the disk: WaypointFiles does, on another thread. The whole list is written at once.
class FileWaypointStore : public WaypointStore {
  Q_OBJECT
 public:
  /// `files` lives on a thread that ends before this does, and is deleted there.
  explicit FileWaypointStore(WaypointFiles* files);

  Call read(const map::MapKey& map, OutcomeTo<StoredWaypoints> reply) override;
  std::vector<WaypointRequest> plan(const StoredWaypoints& now,
                                    const std::vector<WaypointChange>& changes) const override;
  Call perform(const map::MapKey& map, const WaypointRequest& request,
               OutcomeTo<WaypointReceipt> reply) override;

 private:
  wire::LinkRef<WaypointFiles> files_;
};

}  // namespace mapwright::robot::files
