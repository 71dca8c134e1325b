#include "robot/axbot/axbot_capabilities.h"

#include <utility>

#include "robot/axbot/stream_topics.h"

namespace mapwright::robot::axbot {

Call Overview::fetchOverview(double resolution_m, OutcomeTo<map::WholeMap> reply) {
  return link_.ask(map::SubjectKind::Overview, std::move(reply), &AxbotLink::fetchOverview, resolution_m);
}

std::optional<Obstacle> Administration::obstacle(MapChange change, const map::CatalogueEntry* map) const {
  if (change != MapChange::Rename && change != MapChange::Load) return Obstacle::NotOffered;
  if (!map || map->key.kind != map::MapKind::Stored) return Obstacle::NotOfThisMap;
  return change == MapChange::Load && map->is_current ? std::optional(Obstacle::IsLoaded) : std::nullopt;
}

Call Administration::carryOut(const MapOrder& order, OutcomeTo<map::CatalogueEntry> reply) {
  const map::Subject subject = map::subjectOf(order.key);
  switch (order.change) {
    case MapChange::Rename:
      return maps_.change(subject, maps_.telling(changed_, std::move(reply)), &MapRequests::rename, order.key,
                          order.name);
    case MapChange::Load:
      return maps_.change(subject, maps_.telling(changed_, std::move(reply)), &MapRequests::load, order.key);
    default:
      return maps_.refuse(std::move(reply), wire::notOffered(subject, map::AskedFor::Change));
  }
}

QStringList Topics::topicsOf(map::Stream stream) const {
  const StreamTopics topics = axbot::topicsOf(stream);
  return topics.usual + topics.older;
}

}  // namespace mapwright::robot::axbot
