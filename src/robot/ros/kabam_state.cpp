#include "robot/ros/kabam_state.h"

#include <algorithm>
#include <utility>

namespace mapwright::robot::ros {
namespace {

constexpr const char* kCurrent = "/current_map_info";
constexpr const char* kActive = "/map_list";
constexpr const char* kArchived = "/archived_map_list";
constexpr const char* kWaypoints = "/current_map_waypoints";

template <typename T>
bool replace(std::optional<T>& kept, std::optional<T> now) {
  const bool other = !(kept == now);
  kept = std::move(now);
  return other;
}

}  // namespace

std::vector<std::string> KabamState::topics() const {
  return {ns_ + kCurrent, ns_ + kActive, ns_ + kArchived, ns_ + kWaypoints};
}

KabamState::Update KabamState::apply(const std::string& topic,
                                     const std::shared_ptr<const net::rosbridge::Frame>& frame,
                                     const Field& msg) {
  Update update;
  if (!topic.starts_with(ns_)) return update;
  const std::string name = topic.substr(ns_.size());
  update.own = name == kCurrent || name == kActive || name == kArchived || name == kWaypoints;
  if (!update.own) return update;
  if (name == kCurrent) {
    auto current = readMapInfo(msg);
    update.readable = current.has_value();
    if (!current) return update;
    update.maps = replace(current_, std::move(current));
    // Another map, or this one was changed (updated_at): perhaps its waypoints.
    update.waypoints = update.maps;
  } else if (name == kWaypoints) {
    update.readable = readWaypoints(msg, {}, {}).has_value();
    if (!update.readable) return update;
    waypoints_frame_ = frame;
    waypoints_ = msg;
    update.waypoints = true;
  } else {
    auto maps = readMapList(msg, name == kArchived);
    update.readable = maps.has_value();
    if (!maps) return update;
    update.maps = replace(name == kArchived ? archived_ : active_, std::move(maps));
  }
  return update;
}

void KabamState::forget() {
  active_.reset();
  archived_.reset();
  current_.reset();
  waypoints_frame_.reset();
  waypoints_ = {};
  waypoints_lag_ = false;
}

std::vector<KabamMap> KabamState::maps() const {
  std::vector<KabamMap> all;
  const auto has = [&](const std::vector<KabamMap>& maps, const std::string& id) {
    return std::any_of(maps.begin(), maps.end(), [&](const KabamMap& map) { return map.id == id; });
  };
  for (const KabamMap& map : active_.value_or(std::vector<KabamMap>{})) {
    if (!has(all, map.id) && !(archived_ && has(*archived_, map.id))) all.push_back(map);
  }
  // A map being made may not be listed yet.
  if (current_ && !current_->map.id.empty() && !has(all, current_->map.id) &&
      !(archived_ && has(*archived_, current_->map.id)))
    all.push_back(current_->map);
  for (const KabamMap& map : archived_.value_or(std::vector<KabamMap>{})) {
    if (!has(all, map.id)) all.push_back(map);
  }
  return all;
}

std::optional<KabamMap> KabamState::find(const std::string& id) const {
  const std::vector<KabamMap> all = maps();
  const auto found = std::find_if(all.begin(), all.end(), [&](const KabamMap& map) { return map.id == id; });
  return found == all.end() ? std::nullopt : std::optional(*found);
}

std::vector<map::CatalogueEntry> KabamState::entries() const {
  std::vector<map::CatalogueEntry> entries;
  for (const KabamMap& map : maps()) {
    map::CatalogueEntry entry;
    entry.key = {map::MapKind::Stored, map.id};
    entry.name = calledOf(map);
    entry.file_name = map.name;
    entry.uid = map.id;
    entry.index = int(entries.size());
    entry.is_archived = map.archived;
    if (isCurrent(map.id)) {
      entry.is_current = true;
      entry.state = current_->state;
      entry.created_s = current_->created_s;
      entry.modified_s = current_->updated_s;
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

std::optional<map::CatalogueEntry> KabamState::entry(const std::string& id) const {
  const std::vector<map::CatalogueEntry> all = entries();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const map::CatalogueEntry& entry) { return entry.key.id == id; });
  return found == all.end() ? std::nullopt : std::optional(*found);
}

std::optional<StoredWaypoints> KabamState::waypoints(const std::string& fixed_frame) const {
  if (!waypoints_frame_ || !current_ || waypoints_lag_) return std::nullopt;
  auto stored = readWaypoints(waypoints_, current_->map.id, fixed_frame);
  // Only of another map: the topic has not followed the change of maps yet.
  Field rows = waypoints_["waypoints"];
  if (stored && stored->points.empty() && stored->notes.empty() && rows.size() > 0) return std::nullopt;
  return stored;
}

map::MapInfo KabamState::mapInfo() const {
  map::MapInfo info;
  if (!current_) return info;
  // With the name from the catalogue.
  const auto listed = entry(current_->map.id);
  info.name = listed ? listed->name : calledOf(current_->map);
  info.uid = current_->map.id;
  return info;
}

}  // namespace mapwright::robot::ros
