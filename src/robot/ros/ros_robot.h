// A ROS robot with a rosbridge server behind the port, with or without a KABAM map manager.
// Source: rosbridge.md, kabam.md.
#pragma once

#include <QThread>

#include "robot/robot.h"
#include "robot/ros/kabam_capabilities.h"
#include "robot/ros/ros_capabilities.h"
#include "robot/ros/ros_link.h"

namespace mapwright::robot::ros {

class RosRobot : public Robot {
  Q_OBJECT
 public:
  RosRobot(QString address, LinkOptions options, QObject* parent = nullptr);
  ~RosRobot() override;

  QString address() const override { return address_; }
  void connectToRobot() override;
  void disconnectFromRobot() override;
  void trustCertificate(const QString& sha256) override;
  ConnectionState connection() const override { return state_; }
  RobotIdentity identity() const override;
  MapCatalogue* mapCatalogue() override { return &catalogue_; }
  WholeMapSource* wholeMapSource() override { return &whole_maps_; }
  WaypointSource* waypointSource() override { return has_manager_ ? &waypoints_ : nullptr; }
  WaypointStore* waypointStore() override { return has_manager_ ? &waypoint_store_ : nullptr; }
  LiveTopics* liveTopics() override { return &topics_; }
  MapAdministration* mapAdministration() override { return has_manager_ ? &administration_ : nullptr; }
  Absence whyNot(Capability capability) const override;

 private:
  void listen();
  void takeMail();

  QString address_;
  KnownTopics known_;
  std::shared_ptr<wire::TopicMailbox> mailbox_;
  std::shared_ptr<wire::TapPlace> tap_;
  QThread thread_;
  RosLink* link_;  // lives on thread_, deleted when it ends
  Catalogue catalogue_;
  WholeMaps whole_maps_;
  Topics topics_;
  KabamWaypoints waypoints_;
  KabamWaypointStore waypoint_store_;
  KabamAdministration administration_;
  ConnectionState state_;
  bool has_manager_ = false;
};

}  // namespace mapwright::robot::ros
