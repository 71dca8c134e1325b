// What the map manager does with waypoints, and what another operator does to it.
#include <algorithm>

#include "simulator/ros/kabam_store.h"
#include "simulator/ros/shapes.h"

namespace mapwright::simulator::ros {
namespace {

constexpr std::size_t kMostWaypoints = 200'000;

}  // namespace

bool KabamStore::nameTaken(const KabamMap& map, std::string_view name, const KabamWaypoint* but) const {
  return std::any_of(map.waypoints.begin(), map.waypoints.end(), [&](const KabamWaypoint& waypoint) {
    return &waypoint != but && waypoint.name == name;
  });
}

void KabamStore::takeTags(KabamWaypoint& waypoint, const Value& info) const {
  const auto* tags = info["waypoint_tags"].as<Value::List>();
  if (tags == nullptr || (tags->empty() && options_.kabam_empty_tags_keep)) return;
  waypoint.tags.clear();
  for (const Value& tag : *tags) waypoint.tags.push_back(tag.text());
}

WaypointResult KabamStore::find(const Value& info, Place& place) {
  const std::string &map_id = info["map_id"].text(), &id = info["id"].text();
  // Only creating needs the map's id: without it, the waypoint's own has to do.
  if (!map_id.empty() && mapOf(map_id) == nullptr) return WaypointResult::NoSuchMap;
  for (KabamMap& map : maps_) {
    if (!map_id.empty() && map.id != map_id) continue;
    for (KabamWaypoint& waypoint : map.waypoints) {
      if (id.empty() || waypoint.id != id) continue;
      place = {&map, &waypoint};
      return WaypointResult::Updated;
    }
  }
  return WaypointResult::NotFound;
}

WaypointResult KabamStore::create(const Value& info, Value& answer) {
  const std::lock_guard lock(mutex_);
  KabamMap* map = mapOf(info["map_id"].text());
  if (map == nullptr) return WaypointResult::NoSuchMap;
  const std::string& name = info["name"].text();
  if (name.empty() || map->waypoints.size() >= kMostWaypoints) return WaypointResult::Failed;
  if (nameTaken(*map, name, nullptr)) return WaypointResult::NameExists;
  KabamWaypoint waypoint{name, newId(), info["frame_id"].text(), info["pose"], {}};
  takeTags(waypoint, info);
  map->waypoints.push_back(std::move(waypoint));
  answer = waypointMessage(map->waypoints.back(), map->id);
  touch(*map);
  ++edits_.waypoints;
  return WaypointResult::Created;
}

WaypointResult KabamStore::removeWaypoint(const Value& info, bool flag, Value& answer) {
  const std::lock_guard lock(mutex_);
  if (options_.kabam_needs_flags && !flag) return WaypointResult::Failed;
  Place place;
  if (const WaypointResult found = find(info, place); found != WaypointResult::Updated) return found;
  answer = waypointMessage(*place.waypoint, place.map->id);
  place.map->waypoints.erase(place.map->waypoints.begin() + (place.waypoint - place.map->waypoints.data()));
  touch(*place.map);
  ++edits_.waypoints;
  return WaypointResult::Deleted;
}

WaypointResult KabamStore::rename(const Value& info, Value& answer) {
  const std::lock_guard lock(mutex_);
  Place place;
  if (const WaypointResult found = find(info, place); found != WaypointResult::Updated) return found;
  const std::string& name = info["name"].text();
  if (name.empty()) return WaypointResult::Failed;
  if (nameTaken(*place.map, name, place.waypoint)) return WaypointResult::NameExists;
  place.waypoint->name = name;
  takeTags(*place.waypoint, info);
  answer = waypointMessage(*place.waypoint, place.map->id);
  touch(*place.map);
  ++edits_.waypoints;
  return WaypointResult::Updated;
}

WaypointResult KabamStore::reposition(const Value& info, Value& answer) {
  const std::lock_guard lock(mutex_);
  Place place;
  if (const WaypointResult found = find(info, place); found != WaypointResult::Updated) return found;
  place.waypoint->frame_id = info["frame_id"].text();
  place.waypoint->pose = info["pose"];
  takeTags(*place.waypoint, info);
  answer = waypointMessage(*place.waypoint, place.map->id);
  touch(*place.map);
  ++edits_.waypoints;
  return WaypointResult::Updated;
}

void KabamStore::otherOperator() {
  const std::lock_guard lock(mutex_);
  KabamMap* map = mapOf(current_);
  if (current_.empty() || map == nullptr) return;
  const std::uint64_t turn = turns_++;
  const std::string number = std::to_string(turn / 5 + 1);
  switch (turn % 5) {
    case 0:
      if (map->waypoints.empty()) break;
      map->waypoints[turn / 5 % map->waypoints.size()].name = "Renamed by others " + number;
      break;
    case 1:
      if (map->waypoints.empty()) break;
      map->waypoints.back().pose.set("position", xyz(1.5 + 0.25 * static_cast<double>(turn % 16), 2, 0));
      break;
    case 2:
      if (map->waypoints.size() >= kMostWaypoints) break;
      map->waypoints.push_back(waypointAt(*map, 5, "Put here by others " + number, {"other"}));
      break;
    case 3:
      map->label = "Relabelled by others " + number;
      ++edits_.lists;
      break;
    default:
      if (map->waypoints.size() > 4) map->waypoints.erase(map->waypoints.begin() + 4);
  }
  touch(*map);
  ++edits_.waypoints;
}

}  // namespace mapwright::simulator::ros
