// The additional capabilities of a robot with a KABAM map manager. On the thread of the robot.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "robot/map_administration.h"
#include "robot/ros/ros_capabilities.h"
#include "robot/waypoint_store.h"

namespace mapwright::robot::ros {

class KabamWaypoints : public WaypointSource {
 public:
  explicit KabamWaypoints(Line line) : line_(line) {}
  Call waypoints(const map::MapKey& key, OutcomeTo<map::WaypointList> reply) override;

 private:
  Line line_;
  wire::PendingCalls<map::WaypointList> lists_;
};

/// One service call per change; the robot assigns the id of a created waypoint.
class KabamWaypointStore : public WaypointStore {
  Q_OBJECT
 public:
  explicit KabamWaypointStore(RosLink* link, QObject* parent = nullptr);
  /// MapWaypoint has no type, but always an orientation; names are unique within a map.
  KeptFields keeps() const override { return {.type = false, .no_heading = false, .name_twice = false}; }
  Call read(const map::MapKey& map, OutcomeTo<StoredWaypoints> reply) override;
  std::vector<WaypointRequest> plan(const StoredWaypoints& now,
                                    const std::vector<WaypointChange>& changes) const override;
  /// As it will be sent, except for the frame of created waypoints, which only the link knows.
  WaypointCall callOf(const map::MapKey& map, const WaypointRequest& request) const override;
  Call perform(const map::MapKey& map, const WaypointRequest& request,
               OutcomeTo<WaypointReceipt> reply) override;

 private:
  RosLink* link_;
  wire::PendingCalls<StoredWaypoints> reads_;
  wire::PendingCalls<WaypointReceipt> changes_;
};

class KabamAdministration : public MapAdministration {
 public:
  /// `changed` is called, on the thread of the robot, before the answer to a change that may have been
  /// applied.
  KabamAdministration(Line line, std::function<void()> changed) : line_(line), changed_(std::move(changed)) {}
  /// The present state of the manager (IDLE, MAPPING, ACTIVE); empty = unknown.
  void setState(std::string state) { state_ = std::move(state); }
  std::optional<Obstacle> obstacle(MapChange change, const map::CatalogueEntry* map) const override;
  bool loadAsksForPlace() const override { return true; }
  Call carryOut(const MapOrder& order, OutcomeTo<map::CatalogueEntry> reply) override;

 private:
  OutcomeTo<map::CatalogueEntry> telling(OutcomeTo<map::CatalogueEntry> reply) const;

  Line line_;
  std::function<void()> changed_;
  std::string state_;
  wire::PendingCalls<map::CatalogueEntry> changes_;
};

}  // namespace mapwright::robot::ros
