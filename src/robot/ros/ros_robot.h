// A ROS robot with a rosbridge server behind the port, with or without a KABAM map manager.
// Source: docs/protocols/rosbridge.md, docs/protocols/kabam-map-manager.md.
#pragma once

#include "robot/offers_topics.h"
#include "robot/ros/dispatch_capability.h"
#include "robot/ros/kabam_capabilities.h"
#include "robot/ros/ros_capabilities.h"
#include "robot/ros/ros_link.h"
#include "robot/wire/forwarded.h"
#include "robot/wire/network_robot.h"

namespace mapwright::robot::ros {

class RosRobot : public wire::NetworkRobot, public OffersTopics {
  Q_OBJECT
 public:
  RosRobot(QString address, LinkOptions options, QObject* parent = nullptr);
  ~RosRobot() override;

  RobotIdentity identity() const override;
  MapCatalogue* mapCatalogue() override { return &catalogue_; }
  WholeMapSource* wholeMapSource() override { return &whole_maps_; }
  WaypointSource* waypointSource() override { return has_manager_ ? &waypoints_ : nullptr; }
  WaypointStore* waypointStore() override { return has_manager_ ? &waypoint_store_ : nullptr; }
  LiveTopics* liveTopics() override { return &topics_; }
  MapAdministration* mapAdministration() override { return has_manager_ ? &administration_ : nullptr; }
  PictureStore* pictureStore() override { return takes_pictures_ ? &picture_store_ : nullptr; }
  MapDispatch* mapDispatch() override { return has_dispatch_ ? &dispatch_ : nullptr; }
  Absence whyNot(Capability capability) const override;
  void setDeliveryTap(DeliveryTap tap) override;
  std::optional<std::vector<OfferedTopic>> offered() const override;
  QStringList choicesFor(map::Stream stream) const override;
  void choose(const TopicChoices& choices) override;
  TopicChoices chosen() const override { return chosen_; }
  void setEveryMessage(bool on) override;
  std::optional<Reception> reception() const override { return reception_; }

 private:
  /// `longest_message`: as the client takes it, in bytes.
  RosRobot(QString address, wire::StartedLink<RosLink> started, std::int64_t longest_message,
           KnownTopics known, QObject* parent);
  void listen();

  RosLink* link_;
  KnownTopics known_;
  TopicChoices chosen_;
  std::optional<Reception> reception_;
  wire::CatalogueOf<RosMaps> catalogue_;
  wire::WholeMapsOf<RosMaps> whole_maps_;
  Topics topics_;
  KabamWaypointStore waypoint_store_;
  wire::WaypointsOfStore waypoints_;
  KabamPictureStore picture_store_;
  KabamAdministration administration_;
  RosDispatch dispatch_;
  bool has_manager_ = false, takes_pictures_ = false, has_dispatch_ = false;
};

}  // namespace mapwright::robot::ros
