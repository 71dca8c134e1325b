#include "robot/ros/kabam_capabilities.h"

#include <utility>

#include "robot/ros/kabam_messages.h"
#include "robot/ros/kabam_picture.h"
#include "robot/ros/kabam_plan.h"
#include "robot/wire/forwarded.h"

namespace mapwright::robot::ros {

KabamWaypointStore::KabamWaypointStore(RosLink* link) : kabam_(link, &RosLink::kabam) {
  connect(&link->kabam(), &KabamRequests::waypointsChanged, this, &WaypointStore::changed);
}

Call KabamWaypointStore::read(const map::MapKey& key, OutcomeTo<StoredWaypoints> reply) {
  return kabam_.ask(map::placesOf(key), std::move(reply), &KabamRequests::waypoints, key);
}

std::vector<WaypointRequest> KabamWaypointStore::plan(const StoredWaypoints& now,
                                                      const std::vector<WaypointChange>& changes) const {
  return planWaypoints(now, changes);
}

WaypointCall KabamWaypointStore::callOf(const map::MapKey& key, const WaypointRequest& request) const {
  if (request.changes.empty()) return {};
  const WaypointChange& change = request.changes.front();
  const WaypointService service = serviceOf(change);
  const bool creates = service == WaypointService::Create, deletes = service == WaypointService::Delete;
  const QByteArray message =
      waypointJson(deletes ? *change.before : *change.after, creates ? std::string() : change.id, key.id, {});
  return {nameOf(service), manageWaypointArgs(message, deletes).toStdString()};
}

Call KabamWaypointStore::perform(const map::MapKey& key, const WaypointRequest& request,
                                 OutcomeTo<WaypointReceipt> reply) {
  return kabam_.change(map::placesOf(key), std::move(reply), &KabamRequests::perform, key, request);
}

std::optional<Obstacle> KabamAdministration::obstacle(MapChange change,
                                                      const map::CatalogueEntry* map) const {
  const bool mapping = state_ == "MAPPING";
  if (change == MapChange::StartMapping || change == MapChange::StopMapping || change == MapChange::Save) {
    if (state_.empty()) return Obstacle::NotKnownYet;
    if (change == MapChange::StartMapping && mapping) return Obstacle::WhileMapping;
    if (change == MapChange::StopMapping && !mapping) return Obstacle::NotMapping;
    return std::nullopt;
  }
  if (!map || map->key.kind != map::MapKind::Stored) return Obstacle::NotOfThisMap;
  switch (change) {
    case MapChange::Load:
      if (mapping) return Obstacle::WhileMapping;
      if (map->is_archived) return Obstacle::IsArchived;
      return map->is_current ? std::optional(Obstacle::IsLoaded) : std::nullopt;
    case MapChange::Archive:
      if (mapping && map->is_current) return Obstacle::WhileMapping;
      return map->is_archived ? std::optional(Obstacle::IsArchived) : std::nullopt;
    case MapChange::Unarchive:
      return map->is_archived ? std::nullopt : std::optional(Obstacle::IsNotArchived);
    case MapChange::Delete:
      return mapping && map->is_current ? std::optional(Obstacle::WhileMapping) : std::nullopt;
    default:
      return std::nullopt;
  }
}

Call KabamAdministration::carryOut(const MapOrder& order, OutcomeTo<map::CatalogueEntry> reply) {
  return kabam_.change(order.key.id.empty() ? wire::kMapList : map::subjectOf(order.key),
                       kabam_.telling(changed_, std::move(reply)), &KabamRequests::carryOut, order);
}

KabamPictureStore::KabamPictureStore(RosLink* link) : pictures_(link, &RosLink::pictures) {
  connect(&link->pictures(), &KabamPictures::changed, this, [this](const QString& map_id) {
    Q_EMIT changed({map::MapKind::Stored, map_id.toStdString()});
  });
}

std::optional<PictureObstacle> KabamPictureStore::obstacle(const map::WholeMap& map) const {
  if (map.key.kind != map::MapKind::Stored) return PictureObstacle::NotStored;
  return std::nullopt;
}

bool KabamPictureStore::holdsCell(const map::WholeMap&, std::uint8_t cell) const {
  return shadeOf(cell).has_value();
}

Call KabamPictureStore::write(const PictureChange& change, OutcomeTo<PictureReceipt> reply) {
  return pictures_.change(map::subjectOf(change.map), std::move(reply), &KabamPictures::write, change);
}

}  // namespace mapwright::robot::ros

#include "moc_kabam_capabilities.cpp"
