// A map file, or a folder of them, behind the port.
#pragma once

#include <QThread>

#include "robot/files/map_files.h"
#include "robot/files/overlay_file.h"
#include "robot/picture_store.h"
#include "robot/robot.h"
#include "robot/waypoint_store.h"
#include "robot/wire/forwarded.h"
#include "robot/wire/robot_link.h"

namespace mapwright::robot::files {

// Nothing here touches the disk: MapFiles, WaypointFiles and OverlayFiles do, on a thread of their own. It
// ends before the stores do, and deletes them.

/// The pictures of local maps.
class FilePictureStore : public PictureStore {
  Q_OBJECT
 public:
  explicit FilePictureStore(MapFiles* files) : files_(files) {}

  std::optional<PictureObstacle> obstacle(const map::WholeMap& map) const override;
  bool holdsUnknown(const map::WholeMap& map) const override;
  Call write(const PictureChange& change, OutcomeTo<PictureReceipt> reply) override;

 private:
  wire::LinkRef<MapFiles> files_;
};

/// The waypoint lists of local maps. A list is written as a whole.
class FileWaypointStore : public WaypointStore {
  Q_OBJECT
 public:
  explicit FileWaypointStore(WaypointFiles* files);

  Call read(const map::MapKey& map, OutcomeTo<StoredWaypoints> reply) override;
  std::vector<WaypointRequest> plan(const StoredWaypoints& now,
                                    const std::vector<WaypointChange>& changes) const override;
  Call perform(const map::MapKey& map, const WaypointRequest& request,
               OutcomeTo<WaypointReceipt> reply) override;

 private:
  wire::LinkRef<WaypointFiles> files_;
};

/// The overlays of local maps. They are written as a whole.
class FileOverlayStore : public OverlayStore {
 public:
  explicit FileOverlayStore(OverlayFiles* files) : files_(files) {}

  Call read(const map::MapKey& key, OutcomeTo<OverlayText> reply) override;
  Call write(const map::MapKey& key, const std::string& text, OutcomeTo<std::monostate> reply) override;

 private:
  wire::LinkRef<OverlayFiles> files_;
};

class FileRobot : public Robot {
  Q_OBJECT
 public:
  FileRobot(QString address, FileOptions options, QObject* parent = nullptr);
  /// Waits for at most one access to one file.
  ~FileRobot() override;

  QString address() const override { return address_; }
  bool isLocal() const override { return true; }
  void connectToRobot() override;
  void disconnectFromRobot() override;
  ConnectionState connection() const override { return state_; }
  RobotIdentity identity() const override;
  MapCatalogue* mapCatalogue() override { return &catalogue_; }
  WholeMapSource* wholeMapSource() override { return &whole_maps_; }
  WaypointSource* waypointSource() override { return &told_waypoints_; }
  WaypointStore* waypointStore() override { return &waypoints_; }
  PictureStore* pictureStore() override { return &pictures_; }
  OverlayStore* overlayStore() override { return &overlays_; }
  Absence unavailableReason(Capability) const override { return {Absence::Reason::LocalFiles, {}}; }

 private:
  void enter(ConnectionPhase phase, const Fault& reason = {});

  QString address_, path_;
  bool folder_;          // as far as is known
  bool wanted_ = false;  // connected, or about to be
  ConnectionState state_;
  wire::LinkLog link_log_;
  QThread thread_;
  MapFiles* files_;  // lives on thread_, deleted when it ends
  wire::CatalogueOf<MapFiles> catalogue_;
  wire::WholeMapsOf<MapFiles> whole_maps_;
  WaypointFiles* waypoint_files_;  // lives on thread_, deleted when it ends
  FileWaypointStore waypoints_;
  wire::WaypointsOfStore told_waypoints_{waypoints_};
  FilePictureStore pictures_;
  OverlayFiles* overlay_files_;  // lives on thread_, deleted when it ends
  FileOverlayStore overlays_;
};

}  // namespace mapwright::robot::files
