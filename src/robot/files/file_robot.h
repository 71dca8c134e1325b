// A map file, or a folder of them, behind the port.
#pragma once

#include <QThread>

#include "robot/files/file_waypoint_store.h"
#include "robot/files/map_files.h"
#include "robot/files/picture_files.h"
#include "robot/robot.h"
#include "robot/wire/pending_calls.h"

namespace mapwright::robot::files {

/// The caller's context and the objects on the file thread. Both outlive all requests of the capabilities.
struct Line {
  QObject* asker;
  MapFiles* files;
};

class Catalogue : public MapCatalogue {
 public:
  Catalogue(Line line, std::string file_name) : line_(line), file_name_(std::move(file_name)) {}
  Call list(OutcomeTo<std::vector<map::CatalogueEntry>> reply) override;
  Call describe(const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply) override;
  Call thumbnail(const map::MapKey& key, OutcomeTo<std::string> reply) override;

 private:
  Line line_;
  std::string file_name_;
  wire::PendingCalls<std::vector<map::CatalogueEntry>> lists_;
  wire::PendingCalls<map::CatalogueEntry> descriptions_;
  wire::PendingCalls<std::string> thumbnails_;
};

class WholeMaps : public WholeMapSource {
 public:
  explicit WholeMaps(Line line) : line_(line) {}
  Call fetch(const map::MapKey& key, OutcomeTo<map::WholeMap> reply) override;

 private:
  Line line_;
  wire::PendingCalls<map::WholeMap> maps_;
};

/// Nothing here accesses the disk: MapFiles does, on a thread of its own.
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
  Absence whyNot(Capability) const override { return {Absence::Reason::LocalFiles, {}}; }

 private:
  void enter(ConnectionPhase phase, const Fault& reason = {});

  QString address_, path_;
  bool folder_;          // as far as is known
  bool wanted_ = false;  // connected, or about to be
  ConnectionState state_;
  QThread thread_;
  MapFiles* files_;  // lives on thread_, deleted when it ends
  Catalogue catalogue_;
  WholeMaps whole_maps_;
  WaypointFiles* waypoint_files_;  // lives on thread_, deleted when it ends
  FileWaypointStore waypoints_;
  FileWaypoints told_waypoints_{this, waypoint_files_};
  PictureFiles* picture_files_;  // lives on thread_, deleted when it ends
  FilePictureStore pictures_;
};

}  // namespace mapwright::robot::files
