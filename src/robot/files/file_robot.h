// A map file, or a folder of them, behind the port.
#pragma once

#include <chrono>

#include <QFileSystemWatcher>
#include <QTimer>

#include "robot/files/local_maps.h"
#include "robot/robot.h"

namespace mapwright::robot::files {

struct FileOptions {
  QString path;  // absolute; a file or a folder
  PicturePlace place;
  std::chrono::milliseconds settle{200};  // a change is told when this long nothing more has changed
};

/// One file is the map with the key {File, ""}; in a folder each map file is one, its name the id. Nothing
/// here opens pictures. Works on the thread that made it.
class FileRobot : public Robot, private MapCatalogue, private WholeMapSource {
  Q_OBJECT
 public:
  FileRobot(QString address, FileOptions options, QObject* parent = nullptr);

  QString address() const override { return address_; }
  void connectToRobot() override;
  void disconnectFromRobot() override;
  ConnectionState connection() const override { return state_; }
  RobotIdentity identity() const override;
  MapCatalogue* mapCatalogue() override { return this; }
  WholeMapSource* wholeMapSource() override { return this; }
  QString limits() const override;

 private:
  void list(AnswerTo<std::vector<map::CatalogueEntry>> reply) override;
  void describe(const map::MapKey& key, AnswerTo<map::CatalogueEntry> reply) override;
  void thumbnail(const map::MapKey& key, AnswerTo<std::string> reply) override;
  void fetch(const map::MapKey& key, AnswerTo<map::WholeMap> reply) override;

  template <typename T>
  void later(AnswerTo<T> reply, Answer<T> answer);
  bool isFolder() const;
  /// The file of a key; empty when there is none.
  QString pathOf(const map::MapKey& key) const;
  map::Problem problem(const map::MapKey& key, std::string sentence, map::Severity severity) const;
  /// Watches what the maps are made of, and says what it is like now.
  QStringList watchAndStamp();
  void enter(ConnectionPhase phase, const QString& reason = {});
  void look();
  void tellChange();

  QString address_;
  FileOptions options_;
  ConnectionState state_;
  QFileSystemWatcher watcher_;
  QTimer settle_;
  QStringList stamps_;
};

}  // namespace mapwright::robot::files
