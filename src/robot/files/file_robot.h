// A map file, or a folder of them, behind the port.
#pragma once

#include <QThread>

#include "robot/files/map_files.h"
#include "robot/robot.h"
#include "robot/wire/pending_answers.h"

namespace mapwright::robot::files {

/// Nothing here touches the disk: MapFiles does, on a thread of its own.
class FileRobot : public Robot, private MapCatalogue, private WholeMapSource {
  Q_OBJECT
 public:
  FileRobot(QString address, FileOptions options, QObject* parent = nullptr);
  /// Waits for at most one look at one file.
  ~FileRobot() override;

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
  void enter(ConnectionPhase phase, const QString& reason = {});

  QString address_, path_;
  bool folder_;          // as far as is known
  bool wanted_ = false;  // connected, or about to be
  ConnectionState state_;
  QThread thread_;
  MapFiles* files_;  // lives on thread_, deleted when it ends
  wire::PendingAnswers<std::vector<map::CatalogueEntry>> lists_;
  wire::PendingAnswers<map::CatalogueEntry> descriptions_;
  wire::PendingAnswers<map::WholeMap> whole_maps_;
};

}  // namespace mapwright::robot::files
