// An Agibot robot behind the port: maps and waypoints to look at. Source: aimdk.md.
#pragma once

#include <QThread>

#include "robot/aimdk/aimdk_link.h"
#include "robot/robot.h"
#include "robot/wire/pending_calls.h"

namespace mapwright::robot::aimdk {

/// Who asks, and who is asked, on a thread of its own. Both outlive the capabilities' questions.
struct Line {
  QObject* asker;
  AimdkLink* link;
};

class Catalogue : public MapCatalogue {
 public:
  explicit Catalogue(Line line) : line_(line) {}
  Call list(OutcomeTo<std::vector<map::CatalogueEntry>> reply) override;
  Call describe(const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply) override;
  Call thumbnail(const map::MapKey& key, OutcomeTo<std::string> reply) override;

 private:
  Line line_;
  wire::PendingCalls<std::vector<map::CatalogueEntry>> lists_;
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

class Points : public WaypointSource {
 public:
  explicit Points(Line line) : line_(line) {}
  Call waypoints(const map::MapKey& key, OutcomeTo<map::WaypointList> reply) override;

 private:
  Line line_;
  wire::PendingCalls<map::WaypointList> lists_;
};

class AimdkRobot : public Robot {
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
  MapCatalogue* mapCatalogue() override { return &catalogue_; }
  WholeMapSource* wholeMapSource() override { return &whole_maps_; }
  WaypointSource* waypointSource() override { return &points_; }
  Absence whyNot(Capability capability) const override;

 private:
  QString address_;
  bool has_tf_ = false;
  QThread thread_;
  AimdkLink* link_;  // lives on thread_, deleted when it ends
  Catalogue catalogue_;
  WholeMaps whole_maps_;
  Points points_;
  ConnectionState state_;
  RobotIdentity identity_;
};

}  // namespace mapwright::robot::aimdk
