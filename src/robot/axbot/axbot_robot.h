// An Autoxing robot behind the port. Source: docs/protocols/autoxing.md.
#pragma once

#include <optional>

#include "robot/axbot/axbot_capabilities.h"
#include "robot/axbot/axbot_link.h"
#include "robot/wire/forwarded.h"
#include "robot/wire/network_robot.h"

namespace mapwright::robot::axbot {

class AxbotRobot : public wire::NetworkRobot {
  Q_OBJECT
 public:
  AxbotRobot(QString address, LinkOptions options, QObject* parent = nullptr);
  ~AxbotRobot() override;

  RobotIdentity identity() const override { return identity_; }
  SubmapSource* submapSource() override { return &submaps_; }
  MapCatalogue* mapCatalogue() override { return &catalogue_; }
  WholeMapSource* wholeMapSource() override { return &whole_maps_; }
  OverviewSource* overviewSource() override { return overview_unknown_ ? nullptr : &overview_; }
  LiveTopics* liveTopics() override { return &topics_; }
  MapAdministration* mapAdministration() override { return &administration_; }
  BagLibrary* bagLibrary() override { return &bags_; }
  Absence whyNot(Capability capability) const override;

 private:
  AxbotRobot(QString address, wire::StartedLink<AxbotLink> started, QObject* parent);
  void takeTopic(const map::StampedMessage& stamped) override;
  void cameOnline() override;

  wire::SubmapsOf<AxbotLink> submaps_;
  wire::CatalogueOf<MapRequests> catalogue_;
  wire::WholeMapsOf<AxbotLink> whole_maps_;
  Overview overview_;
  Topics topics_;
  Administration administration_;
  wire::BagsOf<BagRequests> bags_;
  RobotIdentity identity_;
  std::optional<QString> overview_unknown_;    // its answer to a request for one
  std::optional<map::MapInfo> last_map_info_;  // without overlays
};

}  // namespace mapwright::robot::axbot
