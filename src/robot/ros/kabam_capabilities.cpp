#include "robot/ros/kabam_capabilities.h"

#include <utility>

#include <QPointer>

#include "robot/ros/kabam_messages.h"
#include "robot/ros/kabam_plan.h"

namespace mapwright::robot::ros {

Call KabamWaypoints::waypoints(const map::MapKey& key, OutcomeTo<map::WaypointList> reply) {
  return wire::askAcross(line_.asker, line_.link, lists_, map::placesOf(key), std::move(reply),
                         [key](RosLink& link, auto errand, OutcomeTo<map::WaypointList> answer) {
                           link.waypoints(errand, key, [answer](Outcome<StoredWaypoints> stored) {
                             if (!stored) return answer(tl::make_unexpected(std::move(stored.error())));
                             answer(map::WaypointList{std::move(stored->points), std::move(stored->notes)});
                           });
                         });
}

KabamWaypointStore::KabamWaypointStore(RosLink* link, QObject* parent) : WaypointStore(parent), link_(link) {
  connect(link_, &RosLink::waypointsChanged, this, &WaypointStore::changed);
}

Call KabamWaypointStore::read(const map::MapKey& key, OutcomeTo<StoredWaypoints> reply) {
  return wire::askAcross(
      this, link_, reads_, map::placesOf(key), std::move(reply),
      [key](RosLink& link, auto errand, auto answer) { link.waypoints(errand, key, std::move(answer)); });
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
  return wire::askAcross(
      this, link_, changes_, map::placesOf(key), std::move(reply),
      [key, request](RosLink& link, auto errand, auto answer) {
        link.perform(errand, key, request, std::move(answer));
      },
      wire::Stopping::AsItStands);
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
  const bool of_none = order.key.id.empty();
  return wire::askAcross(
      line_.asker, line_.link, changes_,
      of_none ? map::Subject(map::SubjectKind::Catalogue, map::kMapsPart) : map::subjectOf(order.key),
      telling(std::move(reply)),
      [order](RosLink& link, auto errand, auto answer) { link.carryOut(errand, order, std::move(answer)); },
      wire::Stopping::AsItStands);
}

OutcomeTo<map::CatalogueEntry> KabamAdministration::telling(OutcomeTo<map::CatalogueEntry> reply) const {
  return [asker = QPointer<QObject>(line_.asker), changed = changed_,
          reply = std::move(reply)](Outcome<map::CatalogueEntry> outcome) {
    if (outcome || outcome.error().applied != map::Applied::No) changed();
    if (asker) reply(std::move(outcome));
  };
}

}  // namespace mapwright::robot::ros

#include "moc_kabam_capabilities.cpp"
