// The waypoint lists of local maps behind the port.
#pragma once

#include "robot/files/waypoint_files.h"
#include "robot/robot.h"
#include "robot/waypoint_store.h"
#include "robot/wire/pending_calls.h"

namespace mapwright::robot::files {

/// Nothing here accesses the disk: WaypointFiles does, on another thread. The whole list is written at once.
class FileWaypointStore : public WaypointStore {
  Q_OBJECT
 public:
  /// `files` lives on a thread that ends before this object, and is deleted there.
  explicit FileWaypointStore(WaypointFiles* files, QObject* parent = nullptr);

  Call read(const map::MapKey& map, OutcomeTo<StoredWaypoints> reply) override;
  std::vector<WaypointRequest> plan(const StoredWaypoints& now,
                                    const std::vector<WaypointChange>& changes) const override;
  Call perform(const map::MapKey& map, const WaypointRequest& request,
               OutcomeTo<WaypointReceipt> reply) override;

 private:
  WaypointFiles* files_;
  wire::PendingCalls<StoredWaypoints> reads_;
  wire::PendingCalls<WaypointReceipt> changes_;
};

/// The same lists, read-only.
class FileWaypoints : public WaypointSource {
 public:
  /// `files` as above; `asker` lives on the same thread as this object.
  FileWaypoints(QObject* asker, WaypointFiles* files) : asker_(asker), files_(files) {}
  Call waypoints(const map::MapKey& key, OutcomeTo<map::WaypointList> reply) override;

 private:
  QObject* asker_;
  WaypointFiles* files_;
  wire::PendingCalls<map::WaypointList> reads_;
};

}  // namespace mapwright::robot::files
