// The waypoint lists of local maps: reads, writes and watches them. Lives on the thread of MapFiles: network
// drives may be slow.
#pragma once

#include <map>
#include <memory>
#include <string>

#include <QFileSystemWatcher>
#include <QTimer>

#include "robot/files/map_files.h"
#include "robot/files/waypoint_file.h"

namespace mapwright::robot::files {

class WaypointFiles : public QObject {
  Q_OBJECT
 public:
  explicit WaypointFiles(FileOptions options);

  Outcome<StoredWaypoints> read(const map::MapKey& key);
  /// If the revision on disk differs from the request's it is a FailureKind::Conflict.
  Outcome<WaypointReceipt> write(const map::MapKey& key, const WaypointRequest& request);

 Q_SIGNALS:
  void changed();  // a list that was read, by someone else

 private:
  struct Place {
    map::MapKey key;
    QString map, path;  // path: of the list
  };
  Outcome<Place> placeOf(const map::MapKey& key) const;
  map::Failure failure(const Place& place, map::FailureKind kind, Fault cause) const;
  struct Content {
    std::string bytes;  // empty: there is no file
    StoredWaypoints waypoints;
  };
  Outcome<Content> look(const Place& place) const;
  void watch(const QString& path);
  void compare();

  FileOptions options_;
  std::unique_ptr<QFileSystemWatcher> watcher_;
  std::unique_ptr<QTimer> settle_;
  std::map<QString, std::string> stamps_;  // of the lists that were read
};

}  // namespace mapwright::robot::files
