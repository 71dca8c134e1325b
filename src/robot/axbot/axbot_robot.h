// An Autoxing robot behind the port. Source: docs/protocols/autoxing.md.
#pragma once

#include <optional>

#include <QThread>

#include "robot/axbot/axbot_bags.h"
#include "robot/axbot/axbot_capabilities.h"
#include "robot/axbot/axbot_link.h"
#include "robot/delivery.h"
#include "robot/robot.h"
#include "robot/silence.h"

namespace mapwright::robot::axbot {

class AxbotRobot : public Robot, public Delivers, public MeasuresSilence {
  Q_OBJECT
 public:
  AxbotRobot(QString address, LinkOptions options, QObject* parent = nullptr);
  ~AxbotRobot() override;

  QString address() const override { return address_; }
  void connectToRobot() override;
  void disconnectFromRobot() override;
  void trustCertificate(const QString& sha256) override;
  ConnectionState connection() const override { return state_; }
  QDateTime silentSince() const override { return silent_since_; }
  RobotIdentity identity() const override { return identity_; }
  SubmapSource* submapSource() override { return &submaps_; }
  MapCatalogue* mapCatalogue() override { return &catalogue_; }
  WholeMapSource* wholeMapSource() override { return &whole_maps_; }
  OverviewSource* overviewSource() override { return overview_unknown_ ? nullptr : &overview_; }
  LiveTopics* liveTopics() override { return &topics_; }
  MapAdministration* mapAdministration() override { return &administration_; }
  BagLibrary* bagLibrary() override { return &bags_; }
  Absence whyNot(Capability capability) const override;
  void setDeliveryTap(DeliveryTap tap) override { deliveries_->set(std::move(tap)); }

 private:
  void takeTopic(const map::StampedMessage& stamped);
  void takeMail();

  QString address_;
  std::shared_ptr<wire::TopicMailbox> mailbox_;
  std::shared_ptr<wire::TapPlace> tap_;
  std::shared_ptr<wire::DeliveryPlace> deliveries_;
  QThread thread_;
  AxbotLink* link_;  // lives on thread_, deleted when it ends
  Submaps submaps_;
  Catalogue catalogue_;
  WholeMaps whole_maps_;
  Overview overview_;
  Topics topics_;
  Administration administration_;
  Bags bags_;
  ConnectionState state_;
  QDateTime silent_since_;
  RobotIdentity identity_;
  std::optional<QString> overview_unknown_;    // its answer to a request for one
  std::optional<map::MapInfo> last_map_info_;  // without overlays
};

}  // namespace mapwright::robot::axbot
