// The additional capabilities of a robot with a KABAM map manager. On the thread of the robot.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "robot/map_administration.h"
#include "robot/picture_store.h"
#include "robot/ros/ros_link.h"
#include "robot/waypoint_store.h"
#include "robot/wire/link_ref.h"

namespace mapwright::robot::ros {

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
  void setState(std::string state) { state_ = std::move(state); }
  std::optional<Obstacle> obstacle(MapChange change, const map::CatalogueEntry* map) const override;
  bool loadAsksForPlace() const override { return true; }
  Call carryOut(const MapOrder& order, OutcomeTo<map::CatalogueEntry> reply) override;

 private:
  wire::LinkRef<KabamRequests> kabam_;
  std::function<void()> changed_;
  std::string state_;
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

}  // namespace mapwright::robot::ros
