#include "robot/ros/kabam_capabilities.h"

#include <utility>

#include <QPointer>

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

Call KabamWaypointStore::perform(const map::MapKey& key, const WaypointRequest& request,
                                 OutcomeTo<WaypointReceipt> reply) {
  return wire::askAcross(
      this, link_, changes_, map::placesOf(key), std::move(reply),
      [key, request](RosLink& link, auto errand, auto answer) {
        link.perform(errand, key, request, std::move(answer));
      },
      wire::Stopping::AsItStands);
}

Call KabamAdministration::rename(const map::MapKey& key, const std::string& name,
                                 OutcomeTo<map::CatalogueEntry> reply) {
  return wire::askAcross(
      line_.asker, line_.link, changes_, map::subjectOf(key), telling(std::move(reply)),
      [key, name](RosLink& link, auto errand, auto answer) {
        link.rename(errand, key, name, std::move(answer));
      },
      wire::Stopping::AsItStands);
}

Call KabamAdministration::load(const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply) {
  return wire::askAcross(
      line_.asker, line_.link, changes_, map::subjectOf(key), telling(std::move(reply)),
      [key](RosLink& link, auto errand, auto answer) { link.load(errand, key, {}, std::move(answer)); },
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
