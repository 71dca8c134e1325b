// An Agibot robot behind the port: read-only maps and waypoints; its pose, if a rosbridge beside it provides
// it. Source: docs/protocols/agibot-aimdk.md.
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

/// The caller's context, and the link on its own thread. Both outlive all requests of the capabilities.
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
  /// `live`: the separate source of the robot's pose; null = none.
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
  /// For the interface and for the rosbridge beside it.
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
