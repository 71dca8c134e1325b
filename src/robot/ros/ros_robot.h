// The capabilities that every ROS robot may have: one object each, on the thread of the robot. They call the
// link on its own thread and return its results.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "robot/map_administration.h"
#include "robot/map_dispatch.h"
#include "robot/offers_topics.h"
#include "robot/picture_store.h"
#include "robot/ros/ros_link.h"
#include "robot/waypoint_store.h"
#include "robot/wire/forwarded.h"
#include "robot/wire/link_ref.h"
#include "robot/wire/network_robot.h"

namespace mapwright::robot::ros {

class Topics : public wire::TopicsOf<RosLink> {
 public:
  /// `known` is kept up to date by the robot.
  Topics(RosLink* link, const KnownTopics& known) : TopicsOf(link), known_(known) {}
  QStringList known() const override;
  QStringList topicsOf(map::Stream stream) const override;

 private:
  const KnownTopics& known_;
};

/// One service call for each change; a created waypoint gets its id from the robot.
class KabamWaypointStore : public WaypointStore {
  Q_OBJECT
 public:
  explicit KabamWaypointStore(RosLink* link);
  /// MapWaypoint has no type, and an orientation always; names are told apart within a map.
  KeptFields keeps() const override { return {.type = false, .no_heading = false, .name_twice = false}; }
  Call read(const map::MapKey& map, OutcomeTo<StoredWaypoints> reply) override;
  std::vector<WaypointRequest> plan(const StoredWaypoints& now,
                                    const std::vector<WaypointChange>& changes) const override;
  /// As it will be sent, except for the frame of created waypoints, which only the link knows.
  WaypointCall callOf(const map::MapKey& map, const WaypointRequest& request) const override;
  Call perform(const map::MapKey& map, const WaypointRequest& request,
               OutcomeTo<WaypointReceipt> reply) override;

 private:
  wire::LinkRef<KabamRequests> kabam_;
};

class KabamAdministration : public MapAdministration {
 public:
  /// `changed` is called, on the thread of the robot, before the answer to a change that may have been
  /// applied.
  KabamAdministration(RosLink* link, std::function<void()> changed)
      : kabam_(link, &RosLink::kabam), changed_(std::move(changed)) {}
  /// What the manager does now (IDLE, MAPPING, ACTIVE); empty = it has not said.
  void setState(std::string state) {
    state_ = std::move(state);
    mapped_ = mapped_ || state_ == "MAPPING";
  }
  std::optional<Obstacle> obstacle(MapChange change, const map::CatalogueEntry* map) const override;
  std::string managerState() const override { return state_; }
  bool loadAsksForPlace() const override { return true; }
  Call carryOut(const MapOrder& order, OutcomeTo<map::CatalogueEntry> reply) override;

 private:
  wire::LinkRef<KabamRequests> kabam_;
  std::function<void()> changed_;
  std::string state_;
  bool mapped_ = false;  // since this robot was opened, or a map was saved or loaded here
};

/// The picture of the map that the robot works with, replaced: it is the only one that is sent. An image goes
/// without a place: size, resolution and origin are those that the map has.
class KabamPictureStore : public PictureStore {
  Q_OBJECT
 public:
  explicit KabamPictureStore(RosLink* link);

  std::optional<PictureObstacle> obstacle(const map::WholeMap& map) const override;
  bool holdsUnknown(const map::WholeMap&) const override { return true; }
  bool holdsCell(const map::WholeMap& map, std::uint8_t cell) const override;
  /// Cancelled while it travels, it has not been applied: no part of it counts.
  Call write(const PictureChange& change, OutcomeTo<PictureReceipt> reply) override;

 private:
  wire::LinkRef<KabamPictures> pictures_;
};

class RosDispatch : public MapDispatch {
  Q_OBJECT
 public:
  /// `longest_message`: in bytes; no map comes that is longer.
  RosDispatch(RosLink* link, std::int64_t longest_message);

  /// Called by the robot before it reports changed capabilities.
  void setDispatcher(const Dispatcher& dispatcher);

  std::vector<DispatchOffer> offers() const override { return dispatcher_.offers(); }
  Call grid(const std::optional<map::GridRegion>& region, OutcomeTo<map::GridPart> reply) override;
  Call cloud(CloudKind kind, const std::optional<map::CloudRegion>& region,
             OutcomeTo<std::shared_ptr<const map::SpatialCloud>> reply) override;
  Call save(const std::string& filename, OutcomeTo<std::string> reply) override;
  Call projections(OutcomeTo<std::vector<map::Projection>> reply) override;
  Call project(const std::vector<map::Projection>& wanted,
               OutcomeTo<std::vector<map::Projection>> reply) override;
  std::optional<MapExtent> extent() const override { return extent_; }
  std::vector<ProjectedPart> projected() const override;
  std::vector<std::string> silent() const override { return silent_; }

 private:
  map::Subject subjectOf(DispatchService service) const;
  map::Failure refused(DispatchService service, map::AskedFor asked_for, FaultCode why) const;

  wire::LinkRef<RosLink> link_;
  Dispatcher dispatcher_;
  std::map<int, std::shared_ptr<const ProjectedPart>> projected_;
  std::vector<std::string> silent_;
  std::optional<MapExtent> extent_;
};

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
  Absence unavailableReason(Capability capability) const override;
  void setDeliveryTap(DeliveryTap tap) override;
  std::optional<std::vector<OfferedTopic>> offered() const override;
  QStringList choicesFor(map::Stream stream) const override;
  void choose(const TopicChoices& choices) override;
  TopicChoices chosen() const override { return chosen_; }
  void setEveryMessage(bool on) override;
  std::map<QString, int> unplacedMarkers() const override { return unplaced_markers_; }
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
  std::map<QString, int> unplaced_markers_;
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
