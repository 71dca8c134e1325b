// An Agibot robot behind the port: maps and navigation points to look at. Source: aimdk.md.
#pragma once

#include <QThread>

#include "robot/aimdk/aimdk_link.h"
#include "robot/robot.h"
#include "robot/wire/pending_answers.h"

namespace mapwright::robot::aimdk {

class AimdkRobot : public Robot, private MapCatalogue, private WholeMapSource, private WaypointSource {
  Q_OBJECT
 public:
  AimdkRobot(QString address, LinkOptions options, QObject* parent = nullptr);
  ~AimdkRobot() override;

  QString address() const override { return address_; }
  void connectToRobot() override;
  void disconnectFromRobot() override;
  void trustCertificate(const QString& sha256) override;
  ConnectionState connection() const override { return state_; }
  RobotIdentity identity() const override { return identity_; }
  MapCatalogue* mapCatalogue() override { return this; }
  WholeMapSource* wholeMapSource() override { return this; }
  WaypointSource* waypointSource() override { return this; }
  QString limits() const override;

 private:
  void list(AnswerTo<std::vector<map::CatalogueEntry>> reply) override;
  void describe(const map::MapKey& key, AnswerTo<map::CatalogueEntry> reply) override;
  void thumbnail(const map::MapKey& key, AnswerTo<std::string> reply) override;
  void fetch(const map::MapKey& key, AnswerTo<map::WholeMap> reply) override;
  void waypoints(const map::MapKey& key, AnswerTo<map::WaypointList> reply) override;

  QString address_;
  bool has_tf_ = false;
  QThread thread_;
  AimdkLink* link_;  // lives on thread_, deleted when it ends
  ConnectionState state_;
  RobotIdentity identity_;
  wire::PendingAnswers<std::vector<map::CatalogueEntry>> lists_;
  wire::PendingAnswers<map::WholeMap> whole_maps_;
  wire::PendingAnswers<map::WaypointList> waypoint_lists_;
};

}  // namespace mapwright::robot::aimdk
