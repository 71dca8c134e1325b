// An Agibot robot behind the port: read-only maps and waypoints; its pose, if a rosbridge beside it provides
// it. Source: docs/protocols/agibot-aimdk.md.
#pragma once

#include <memory>
#include <optional>

#include "robot/aimdk/aimdk_link.h"
#include "robot/aimdk/live_beside.h"
#include "robot/second_server.h"
#include "robot/wire/forwarded.h"
#include "robot/wire/network_robot.h"

namespace mapwright::robot::aimdk {

class AimdkRobot : public wire::NetworkRobot, public SecondServer {
  Q_OBJECT
 public:
  /// `live`: the separate source of the robot's pose; null = none.
  AimdkRobot(QString address, LinkOptions options, std::unique_ptr<LiveBeside> live = nullptr,
             QObject* parent = nullptr);
  ~AimdkRobot() override;

  void connectToRobot() override;
  void disconnectFromRobot() override;
  QString hostBeside() const override { return live_ ? live_->host() : QString(); }
  std::optional<UntrustedCertificate> certificateBeside() const override;
  void trustBeside(const QString& sha256) override;
  QDateTime silentSince() const override;
  RobotIdentity identity() const override;
  MapCatalogue* mapCatalogue() override { return &catalogue_; }
  WholeMapSource* wholeMapSource() override { return &whole_maps_; }
  WaypointSource* waypointSource() override { return &points_; }
  LiveTopics* liveTopics() override { return live_.get(); }
  Absence whyNot(Capability capability) const override;
  /// For the interface and for the rosbridge beside it.
  void setDeliveryTap(DeliveryTap tap) override;

 private:
  AimdkRobot(QString address, wire::StartedLink<AimdkLink> started, std::unique_ptr<LiveBeside> live,
             QObject* parent);

  std::unique_ptr<LiveBeside> live_;
  wire::CatalogueOf<AimdkLink> catalogue_;
  wire::WholeMapsOf<AimdkLink> whole_maps_;
  wire::WaypointsOf<AimdkLink> points_;
};

}  // namespace mapwright::robot::aimdk
