// Reads and watches map files. Lives on a thread of its own: folders may be large and network drives slow.
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <string>

#include <QFileSystemWatcher>
#include <QTimer>

#include "robot/files/local_maps.h"
#include "robot/picture_store.h"
#include "robot/robot.h"
#include "robot/waypoint_store.h"

namespace mapwright::robot::files {

struct FileOptions {
  QString path;  // absolute; a file or a folder
  PicturePlace place;
  std::chrono::milliseconds settle{200};  // a change is reported after this much time without another one
};

/// A single file is the map with the key {File, ""}; in a folder each map file is one, with its name as the
/// id. Nothing here opens pictures. Long operations end early when the thread is asked to stop.
class MapFiles : public QObject {
  Q_OBJECT
 public:
  explicit MapFiles(FileOptions options);

  void watch();  // reads, and reports every change from now on
  void leave();

  Outcome<std::vector<map::CatalogueEntry>> list();
  Outcome<map::CatalogueEntry> describe(const map::MapKey& key);
  /// Of a map that is not too large.
  Outcome<std::string> thumbnail(const map::MapKey& key);
  Outcome<map::WholeMap> fetch(const map::MapKey& key);
  /// Its picture, written anew so that it says the right thing: the map.yaml is not touched.
  Outcome<PictureReceipt> writePicture(const PictureChange& change);

 Q_SIGNALS:
  /// `trouble` is None if there is something to show.
  void looked(bool folder, const mapwright::Fault& trouble);
  void changed();

 private:
  void start();
  bool isFolder() const;
  /// The file of a key; empty when there is none.
  QString pathOf(const map::MapKey& key) const;
  map::Failure failure(const map::MapKey& key, map::FailureKind kind) const;
  /// Watches the files of the maps, and returns their present stamps.
  QStringList watchAndStamp();
  void look();
  void notifyChanged();

  FileOptions options_;
  YamlShelf yamls_;
  std::unique_ptr<QFileSystemWatcher> watcher_;
  std::unique_ptr<QTimer> settle_;
  QStringList stamps_;
};

/// The waypoint lists of local maps: reads, writes and watches them. Lives on the same thread.
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
  struct Location {
    map::MapKey key;
    QString map, path;  // path: of the list
  };
  Outcome<Location> locationOf(const map::MapKey& key) const;
  map::Failure failure(const Location& location, map::FailureKind kind, Fault cause) const;
  struct Content {
    std::string bytes;  // empty: there is no file
    StoredWaypoints waypoints;
  };
  Outcome<Content> look(const Location& location) const;
  void watch(const QString& path);
  void compare();

  FileOptions options_;
  std::unique_ptr<QFileSystemWatcher> watcher_;
  std::unique_ptr<QTimer> settle_;
  std::map<QString, std::string> stamps_;  // of the lists that were read
};

}  // namespace mapwright::robot::files
