// An Agibot robot behind the port: maps and waypoints to look at; where it is, if a rosbridge beside it
// tells. Source: docs/protocols/agibot-aimdk.md.
#pragma once

#include <QThread>

#include "robot/aimdk/aimdk_link.h"
#include "robot/aimdk/live_beside.h"
#include "robot/delivery.h"
#include "robot/robot.h"
#include "robot/second_server.h"
#include "robot/silence.h"
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

class AimdkRobot : public Robot, public SecondServer, public Delivers, public MeasuresSilence {
  Q_OBJECT
 public:
  /// `live`: what is beside the interface and tells where the robot is; null = nothing.
  AimdkRobot(QString address, LinkOptions options, std::unique_ptr<LiveBeside> live = nullptr,
             QObject* parent = nullptr);
  ~AimdkRobot() override;

  QString address() const override { return address_; }
  void connectToRobot() override;
  void disconnectFromRobot() override;
  void trustCertificate(const QString& sha256) override;
  QString hostBeside() const override { return live_ ? live_->host() : QString(); }
  std::optional<UntrustedCertificate> certificateBeside() const override;
  void trustBeside(const QString& sha256) override;
  ConnectionState connection() const override { return state_; }
  QDateTime silentSince() const override;
  RobotIdentity identity() const override { return identity_; }
  MapCatalogue* mapCatalogue() override { return &catalogue_; }
  WholeMapSource* wholeMapSource() override { return &whole_maps_; }
  WaypointSource* waypointSource() override { return &points_; }
  LiveTopics* liveTopics() override { return live_.get(); }
  Absence whyNot(Capability capability) const override;
  /// Of the interface and of what is beside it.
  void setDeliveryTap(DeliveryTap tap) override;

 private:
  QString address_;
  std::unique_ptr<LiveBeside> live_;
  std::shared_ptr<wire::DeliveryPlace> deliveries_;
  QThread thread_;
  AimdkLink* link_;  // lives on thread_, deleted when it ends
  Catalogue catalogue_;
  WholeMaps whole_maps_;
  Points points_;
  ConnectionState state_;
  QDateTime silent_since_;
  RobotIdentity identity_;
};

}  // namespace mapwright::robot::aimdk
