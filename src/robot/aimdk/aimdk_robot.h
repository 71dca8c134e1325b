// An Agibot robot behind the port: read-only maps and waypoints; its pose, if a rosbridge beside it provides
// it. Source: docs/protocols/agibot-aimdk.md.
#pragma once

#include <memory>
#include <optional>

#include "robot/aimdk/aimdk_link.h"
#include "robot/second_server.h"
#include "robot/wire/forwarded.h"
#include "robot/wire/network_robot.h"

namespace mapwright::robot::aimdk {

/// The rosbridge beside the interface as a robot with LiveTopics: pose, goal and sensor data. Its maps are
/// not used. `host`: "10.0.0.7:9090", for messages.
struct RobotBeside {
  std::unique_ptr<Robot> robot;
  QString host;
};

class AimdkRobot : public wire::NetworkRobot, public SecondServer {
  Q_OBJECT
 public:
  AimdkRobot(QString address, LinkOptions options, RobotBeside beside = {}, QObject* parent = nullptr);
  ~AimdkRobot() override;

  void connectToRobot() override;
  void disconnectFromRobot() override;
  QString hostBeside() const override { return beside_.robot ? beside_.host : QString(); }
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
  AimdkRobot(QString address, wire::StartedLink<AimdkLink> started, RobotBeside beside, QObject* parent);
  void listenBeside();
  void connectBeside();
  void noteBeside();
  void recoverBeside();

  RobotBeside beside_;
  std::unique_ptr<LiveTopics> live_;  // of the one beside
  bool beside_wanted_ = false;
  QString trusted_beside_;            // SHA-256 to be passed on; empty = none
  std::optional<Fault> away_beside_;  // why it is away, as reported
  std::optional<UntrustedCertificate> certificate_beside_;
  QDateTime silent_beside_;
  wire::CatalogueOf<AimdkLink> catalogue_;
  wire::WholeMapsOf<AimdkLink> whole_maps_;
  wire::WaypointsOf<AimdkLink> points_;
};

}  // namespace mapwright::robot::aimdk
