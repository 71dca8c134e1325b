// An Agibot robot behind the port: maps and waypoints, read-only unless its firmware is newer; its pose, if a
// rosbridge beside it provides it. Source: docs/protocols/agibot-aimdk.md.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "robot/aimdk/aimdk_link.h"
#include "robot/map_administration.h"
#include "robot/second_server.h"
#include "robot/waypoint_store.h"
#include "robot/wire/forwarded.h"
#include "robot/wire/network_robot.h"

namespace mapwright::robot::aimdk {

/// The rosbridge beside the interface as a robot with LiveTopics: pose, goal and sensor data. Its maps are
/// not used. `host`: "10.0.0.7:9090", for messages.
struct RobotBeside {
  std::unique_ptr<Robot> robot;
  QString host;
};

class AimdkAdministration : public MapAdministration {
 public:
  /// `changed` is called, on the thread of the robot, before the answer to a change that may have been
  /// applied.
  AimdkAdministration(AimdkLink* link, std::function<void()> changed)
      : changes_(link, &AimdkLink::maps), changed_(std::move(changed)) {}
  void setMapping(std::optional<bool> mapping) { mapping_ = mapping; }
  std::optional<Obstacle> obstacle(MapChange change, const map::CatalogueEntry* map) const override;
  Call carryOut(const MapOrder& order, OutcomeTo<map::CatalogueEntry> reply) override;

 private:
  wire::LinkRef<MapChanges> changes_;
  std::function<void()> changed_;
  std::optional<bool> mapping_;  // nullopt: not known
};

/// One request for each change; a created waypoint gets its id from the robot.
class AimdkWaypointStore : public WaypointStore {
  Q_OBJECT
 public:
  explicit AimdkWaypointStore(AimdkLink* link) : points_(link, &AimdkLink::points) {}
  KeptFields keeps() const override {
    return {.tags = false,
            .no_heading = false,
            .removal = false,
            .usual_type = kUsualPointType,
            .pixel_m = pixel_m_};
  }
  Call read(const map::MapKey& map, OutcomeTo<StoredWaypoints> reply) override;
  std::vector<WaypointRequest> plan(const StoredWaypoints& now,
                                    const std::vector<WaypointChange>& changes) const override;
  /// In metres: only the link knows the pixels.
  WaypointCall callOf(const map::MapKey& map, const WaypointRequest& request) const override;
  Call perform(const map::MapKey& map, const WaypointRequest& request,
               OutcomeTo<WaypointReceipt> reply) override;

 private:
  wire::LinkRef<PointChanges> points_;
  double pixel_m_ = 0;
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
  WaypointStore* waypointStore() override { return has_newer_ == true ? &waypoint_store_ : nullptr; }
  MapAdministration* mapAdministration() override { return has_newer_ == true ? &administration_ : nullptr; }
  LiveTopics* liveTopics() override { return live_.get(); }
  bool isUnconfirmed(Capability capability) const override;
  Absence unavailableReason(Capability capability) const override;
  /// For the interface and for the rosbridge beside it.
  void setDeliveryTap(DeliveryTap tap) override;

 private:
  AimdkRobot(QString address, wire::StartedLink<AimdkLink> started, RobotBeside beside, QObject* parent);
  void listenBeside();
  void connectBeside();
  void updateCompanion();
  void recoverBeside();

  RobotBeside beside_;
  std::unique_ptr<LiveTopics> live_;  // of the robot beside it
  bool beside_wanted_ = false;
  QString trusted_beside_;            // SHA-256 to be passed on; empty = none
  std::optional<Fault> away_beside_;  // why it is away, as reported
  std::optional<UntrustedCertificate> certificate_beside_;
  QDateTime silent_beside_;
  wire::CatalogueOf<AimdkLink> catalogue_;
  wire::WholeMapsOf<AimdkLink> whole_maps_;
  wire::WaypointsOf<AimdkLink> points_;
  AimdkAdministration administration_;
  AimdkWaypointStore waypoint_store_;
  std::optional<bool> has_newer_;  // firmware; nullopt = it has not told yet
};

}  // namespace mapwright::robot::aimdk
