// An Autoxing robot behind the port. Source: docs/protocols/autoxing.md.
#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "robot/axbot/axbot_link.h"
#include "robot/localization.h"
#include "robot/map_administration.h"
#include "robot/map_transfer.h"
#include "robot/overlay_store.h"
#include "robot/sighting_source.h"
#include "robot/wire/forwarded.h"
#include "robot/wire/network_robot.h"

namespace mapwright::robot::axbot {

// The capabilities of an Autoxing robot live on the thread of the robot. They call the link on its own
// thread.

class Overview : public OverviewSource {
 public:
  explicit Overview(AxbotLink* link) : link_(link) {}
  Call fetchOverview(double resolution_m, OutcomeTo<map::WholeMap> reply) override {
    return link_.ask(map::SubjectKind::Overview, std::move(reply), &AxbotLink::fetchOverview, resolution_m);
  }

 private:
  wire::LinkRef<AxbotLink> link_;
};

class Administration : public MapAdministration {
 public:
  /// `changed` is called, on the thread of the robot, before the answer to a change that may have been
  /// applied.
  Administration(AxbotLink* link, std::function<void()> changed)
      : changes_(link, &AxbotLink::changes), changed_(std::move(changed)) {}
  /// Whether the robot is mapping, as it says. True if that is news.
  bool onMapping(std::optional<bool> mapping) { return std::exchange(mapping_, mapping) != mapping; }
  std::optional<Obstacle> obstacle(MapChange change, const map::CatalogueEntry* map) const override;
  Call carryOut(const MapOrder& order, OutcomeTo<map::CatalogueEntry> reply) override;
  bool tellsProgress() const override { return true; }
  bool savesListed() const override { return true; }
  Call progress(OutcomeTo<std::optional<MappingProgress>> reply) override;

 private:
  wire::LinkRef<MapChanges> changes_;
  std::function<void()> changed_;
  std::optional<bool> mapping_;  // nullopt: not known
};

class Sightings : public SightingSource {
 public:
  explicit Sightings(AxbotLink* link) : sightings_(link, &AxbotLink::sightings) {}
  Call look(Sight what, SightEdge edge, OutcomeTo<Sighting> reply) override {
    return sightings_.ask(kHere, std::move(reply), &SightingRequests::look, what, edge);
  }
  Call collectedLandmarks(OutcomeTo<CollectedLandmarks> reply) override {
    return sightings_.ask(kHere, std::move(reply), &SightingRequests::collectedLandmarks);
  }
  QStringList topics() const override { return sightingTopics(); }

 private:
  static inline const map::Subject kHere = map::subjectOf({map::MapKind::Live, {}});
  wire::LinkRef<SightingRequests> sightings_;
};

class PoseSetting : public Localization {
 public:
  explicit PoseSetting(AxbotLink* link) : poses_(link, &AxbotLink::poses) {}
  Call setPose(const PoseOrder& order, OutcomeTo<geometry::Pose2> reply) override {
    return poses_.change({map::SubjectKind::Robot}, std::move(reply), &PoseRequests::setPose, order);
  }
  Call findItself(OutcomeTo<map::GlobalPositioning> reply) override {
    return poses_.change({map::SubjectKind::Robot}, std::move(reply), &PoseRequests::findItself);
  }

 private:
  wire::LinkRef<PoseRequests> poses_;
};

class Transfer : public MapTransfer {
 public:
  /// `changed`: as for Administration.
  Transfer(AxbotLink* link, std::function<void()> changed)
      : transfers_(link, &AxbotLink::transfers), changed_(std::move(changed)) {}
  Call parts(const map::MapKey& key, OutcomeTo<MapParts> reply) override {
    return transfers_.ask(map::subjectOf(key), std::move(reply), &TransferRequests::parts, key);
  }
  Call download(const MapFacts& of, const QString& path, OutcomeTo<DataDownload> reply) override {
    return transfers_.ask(map::subjectOf(of.key, of.name), std::move(reply), &TransferRequests::download, of,
                          path);
  }
  Call add(const NewMap& map, OutcomeTo<MapParts> reply) override {
    return transfers_.change({map::SubjectKind::Map, {}, map.name},
                             transfers_.telling(changed_, std::move(reply)), &TransferRequests::add, map);
  }

 private:
  wire::LinkRef<TransferRequests> transfers_;
  std::function<void()> changed_;
};

class Overlays : public OverlayStore {
 public:
  /// `changed`: as for Administration.
  Overlays(AxbotLink* link, std::function<void()> changed)
      : overlays_(link, &AxbotLink::overlays), sightings_(link), changed_(std::move(changed)) {}
  Call read(const map::MapKey& key, OutcomeTo<OverlayText> reply) override {
    return overlays_.ask(map::subjectOf(key), std::move(reply), &OverlayRequests::read, key);
  }
  Call write(const map::MapKey& key, const std::string& text, OutcomeTo<std::monostate> reply) override {
    return overlays_.change(map::subjectOf(key), overlays_.telling(changed_, std::move(reply)),
                            &OverlayRequests::write, key, text);
  }
  SightingSource* sightings() override { return &sightings_; }

 private:
  wire::LinkRef<OverlayRequests> overlays_;
  Sightings sightings_;
  std::function<void()> changed_;
};

class Topics : public wire::TopicsOf<AxbotLink> {
 public:
  using TopicsOf::TopicsOf;
  QStringList known() const override { return knownTopics(); }
  QStringList topicsOf(map::Stream stream) const override {
    const StreamTopics topics = axbot::topicsOf(stream);
    return topics.usual + topics.older;
  }
};

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
  OverlayStore* overlayStore() override { return &overlays_; }
  Localization* localization() override { return &pose_setting_; }
  MapTransfer* mapTransfer() override { return &transfer_; }
  Absence unavailableReason(Capability capability) const override;
  std::optional<std::string> jsonOf(const Delivery& message) const override;

 private:
  AxbotRobot(QString address, wire::StartedLink<AxbotLink> started, QObject* parent);
  void onTopic(const map::StampedMessage& stamped) override;
  void cameOnline() override;

  wire::SubmapsOf<AxbotLink> submaps_;
  wire::CatalogueOf<MapRequests> catalogue_;
  wire::WholeMapsOf<AxbotLink> whole_maps_;
  Overview overview_;
  Topics topics_;
  Administration administration_;
  wire::BagsOf<BagRequests> bags_;
  Overlays overlays_;
  PoseSetting pose_setting_;
  Transfer transfer_;
  RobotIdentity identity_;
  std::optional<QString> overview_unknown_;    // its answer to a request for one
  std::optional<map::MapInfo> last_map_info_;  // without overlays
};

}  // namespace mapwright::robot::axbot
