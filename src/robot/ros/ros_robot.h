// A ROS robot with a rosbridge server behind the port, with or without a KABAM map manager.
// Source: docs/protocols/rosbridge.md, docs/protocols/kabam-map-manager.md.
#pragma once

#include <QThread>

#include "robot/delivery.h"
#include "robot/offers_topics.h"
#include "robot/robot.h"
#include "robot/ros/dispatch_capability.h"
#include "robot/ros/kabam_capabilities.h"
#include "robot/ros/kabam_picture_store.h"
#include "robot/ros/ros_capabilities.h"
#include "robot/ros/ros_link.h"
#include "robot/silence.h"

namespace mapwright::robot::ros {

class RosRobot : public Robot, public Delivers, public OffersTopics, public MeasuresSilence {
  Q_OBJECT
 public:
  RosRobot(QString address, LinkOptions options, QObject* parent = nullptr);
  ~RosRobot() override;

  QString address() const override { return address_; }
  void connectToRobot() override;
  void disconnectFromRobot() override;
  void trustCertificate(const QString& sha256) override;
  ConnectionState connection() const override { return state_; }
  QDateTime silentSince() const override { return silent_since_; }
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
  void listen();
  void takeMail();

  QString address_;
  KnownTopics known_;
  TopicChoices chosen_;
  std::optional<Reception> reception_;
  std::shared_ptr<wire::TopicMailbox> mailbox_;
  std::shared_ptr<wire::TapPlace> tap_;
  std::shared_ptr<wire::DeliveryPlace> deliveries_;
  QThread thread_;
  RosLink* link_;  // lives on thread_, deleted when it ends
  Catalogue catalogue_;
  WholeMaps whole_maps_;
  Topics topics_;
  KabamWaypoints waypoints_;
  KabamWaypointStore waypoint_store_;
  KabamPictureStore picture_store_;
  KabamAdministration administration_;
  RosDispatch dispatch_;
  ConnectionState state_;
  QDateTime silent_since_;
  bool has_manager_ = false, takes_pictures_ = false, has_dispatch_ = false;
};

}  // namespace mapwright::robot::ros
