#include "simulator/ros/kabam_store.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "simulator/noise.h"
#include "simulator/ros/ros_messages.h"

namespace mapwright::simulator::ros {
namespace {

constexpr double kScansPerS = kSpeedMPerS / kScanStepM;
constexpr int kScansAtMappingStart = 8;
constexpr std::size_t kMostMaps = 1000, kMostWaypoints = 200'000;
constexpr double kDayS = 86'400;

// The services' own codes.
enum class SaveResult { Saved = 0, Invalid = 1, NameExists = 2, Failed = 3 };
enum class LoadResult { Loaded = 0, NoSuchMap = 1, AlreadyLoaded = 2, Invalid = 3 };
enum class UpdateResult { Updated = 0, Deleted = 1, NoSuchMap = 2, Invalid = 3 };

Value resultOf(auto result) { return Value::Object{{"result", static_cast<int>(result)}}; }

Value triggered(bool done, std::string_view verb, std::string_view past) {
  return Value::Object{{"success", done},
                       {"message", done ? "Mapping " + std::string(past)
                                        : "Invalid request to " + std::string(verb) + " mapping"}};
}

bool isUsable(std::string_view name) { return !name.empty() && name.size() <= 255; }

/// kabam_msgs/MapWaypoint.
Value waypointMessage(const KabamWaypoint& waypoint, std::string_view map_id) {
  Value::List tags(waypoint.tags.begin(), waypoint.tags.end());
  return Value::Object{{"name", waypoint.name}, {"id", waypoint.id}, {"frame_id", waypoint.frame_id},
                       {"pose", waypoint.pose}, {"map_id", map_id},  {"waypoint_tags", std::move(tags)}};
}

bool isTaken(const KabamMap& map, std::string_view name, const KabamWaypoint* but = nullptr) {
  return std::any_of(map.waypoints.begin(), map.waypoints.end(), [&](const KabamWaypoint& waypoint) {
    return &waypoint != but && waypoint.name == name;
  });
}

}  // namespace

enum class KabamStore::WaypointResult {
  Created = 0,
  NoSuchMap = 1,
  NameExists = 2,
  Updated = 3,
  NotFound = 4,
  Deleted = 5,
  Failed = 6
};

KabamStore::KabamStore(const RobotState& state, MapPictures& pictures, const FaultPlan& faults,
                       const Options& options)
    : robot_(state), pictures_(pictures), faults_(faults), options_(options.ros), seed_(options.seed) {
  if (!state.scene().trajectories.empty()) furnish(std::clamp(options_.waypoints, 0, 100'000));
}

void KabamStore::furnish(int waypoints) {
  struct Kept {
    const char *name, *label;
    int trajectory;
    double resolution_m, created_days, updated_days;
    bool archived;
  };
  const Kept kept[] = {{"ground_floor", "Ground floor", 0, 0.05, -40, -2, false},
                       {"annex", "Anbau Süd", 2, 0.05, -30, -30, false},
                       {"gatehouse", "前台大厅", 3, 0.1, -300, -12, false},
                       {"ground_floor_old", "Ground floor (before the move)", 0, 0.1, -700, -650, true}};
  for (const Kept& one : kept) {
    KabamMap map;
    map.id = newId();
    map.name = one.name;
    map.label = one.label;
    map.created_s = one.created_days * kDayS;
    map.updated_s = one.updated_days * kDayS;
    map.archived = one.archived;
    map.spec = {one.trajectory, one.resolution_m};
    map.waypoints.push_back(waypointAt(map, 2, "Start", {"localisation", "map_entry"}));
    maps_.push_back(std::move(map));
  }
  struct Named {
    const char* name;
    std::vector<std::string> tags;
  };
  const Named named[] = {{"Dock", {"localisation"}},
                         {"Lift", {"map_entry"}},
                         {"Café", {}},
                         {"Kitchen", {"delivery"}},
                         {"Printer", {}},
                         {"Meeting room 1", {"delivery"}},
                         {"Meeting room 2", {"delivery"}},
                         {"Lager Süd", {"charger", "delivery"}},
                         {"会议室", {}},
                         {"Exit", {"map_entry"}},
                         {"<b>Bold</b> & co", {"x y"}}};
  KabamMap& first = maps_.front();
  first.waypoints.resize(static_cast<std::size_t>(std::min(waypoints, 1)));
  const Trajectory* way = robot_.scene().find(0);
  const double step = way == nullptr ? 0 : (way->drive.length_m() - 4) / std::max(1, waypoints);
  for (int i = 1; i < waypoints; ++i) {
    const auto at = static_cast<std::size_t>(i - 1);
    const Named usual = at < std::size(named) ? named[at] : Named{"Waypoint ", {}};
    const std::string number = at < std::size(named) ? std::string() : std::to_string(i + 1);
    first.waypoints.push_back(waypointAt(first, 2 + step * i, usual.name + number, usual.tags));
  }
  if (waypoints > 3) first.waypoints[3].frame_id.clear();  // as some managers send it
  current_ = first.id;
  state_ = ManagerState::Active;
}

std::string KabamStore::newId() {
  std::string id = hexDigits(hashOf(seed_, 97, ids_++), 32);
  for (const std::size_t at : {8UL, 13UL, 18UL, 23UL}) id.insert(at, "-");
  return id;
}

KabamWaypoint KabamStore::waypointAt(const KabamMap& map, double metres, std::string name,
                                     std::vector<std::string> tags) {
  KabamWaypoint waypoint{std::move(name), newId(), "map", {}, std::move(tags)};
  const Trajectory* way = robot_.scene().find(map.spec.trajectory);
  waypoint.pose = poseOf(way == nullptr ? geometry::Pose2{} : way->drive.at(metres));
  return waypoint;
}

ManagerState KabamStore::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

std::vector<KabamMap> KabamStore::maps() const {
  const std::lock_guard lock(mutex_);
  return maps_;
}

std::optional<KabamMap> KabamStore::current() const {
  const std::lock_guard lock(mutex_);
  return copyOf(byId(maps_, current_));
}

KabamEdits KabamStore::edits() const {
  const std::lock_guard lock(mutex_);
  return edits_;
}

std::optional<RasterSource> KabamStore::raster() const {
  const std::lock_guard lock(mutex_);
  if (isMapping()) return RasterSource{{}, 0, mappedUntil(robot_.time()), nullptr};
  const KabamMap* const map = byId(maps_, current_);
  if (map == nullptr) return std::nullopt;
  return RasterSource{map->id, map->picture_edits, map->spec, map->image};
}

/// What the mapping has seen.
PictureSpec KabamStore::mappedUntil(double time_s) const {
  const double since_s = *mapping_since_s_;
  return {.trajectory = 1,
          .scans = kScansAtMappingStart + static_cast<int>(kScansPerS * std::floor(time_s - since_s)),
          .from_m = kSpeedMPerS * since_s};
}

KabamMap* KabamStore::mapOf(std::string_view id) { return byId(maps_, id); }

void KabamStore::touch(KabamMap& map) {
  map.updated_s = robot_.time();
  if (map.id == current_) ++edits_.info;
}

std::vector<Service> KabamStore::services() {
  const auto row = [this](const char* name, std::string_view type, Call call, bool changes = true) {
    return Service{std::string("/map_manager/") + name, type,
                   [this, call](const Value& request, bool keep) { return answer(call, request, keep); },
                   changes};
  };
  return {row("start_mapping", "std_srvs/Trigger", &KabamStore::startMapping),
          row("stop_mapping", "std_srvs/Trigger", &KabamStore::stopMapping),
          row("save_map", "kabam_msgs/SaveMap", &KabamStore::saveMap),
          row("load_map", "kabam_msgs/LoadMap", &KabamStore::loadMap),
          row("delete_map", "kabam_msgs/UpdateMap", &KabamStore::deleteMap),
          row("archive_map", "kabam_msgs/UpdateMap", &KabamStore::archiveMap),
          row("rename_map", "kabam_msgs/UpdateMap", &KabamStore::renameMap),
          row("update_map_image", "kabam_msgs/UpdateMap", &KabamStore::updateMapImage),
          row("create_waypoint", "kabam_msgs/ManageWaypoint", &KabamStore::createWaypoint),
          row("delete_waypoint", "kabam_msgs/ManageWaypoint", &KabamStore::deleteWaypoint),
          row("rename_waypoint", "kabam_msgs/ManageWaypoint", &KabamStore::renameWaypoint),
          row("reposition_waypoint", "kabam_msgs/ManageWaypoint", &KabamStore::repositionWaypoint),
          row("get_waypoint", "kabam_msgs/GetWaypoint", &KabamStore::getWaypoint, false)};
}

Value KabamStore::answer(Call call, const Value& request, bool keep) {
  const std::lock_guard lock(mutex_);
  if (keep) return (this->*call)(request);
  auto before = std::tuple(maps_, current_, state_, mapping_since_s_, mapping_until_s_, edits_);
  Value answer = (this->*call)(request);
  std::tie(maps_, current_, state_, mapping_since_s_, mapping_until_s_, edits_) = std::move(before);
  return answer;
}

Value KabamStore::startMapping(const Value&) {
  const bool may = !isMapping() && robot_.canMap();
  if (may) {
    state_ = ManagerState::Mapping;
    mapping_since_s_ = robot_.time();
    current_.clear();
    ++edits_.info, ++edits_.waypoints, ++edits_.picture;
  }
  return triggered(may, "start", "started");
}

Value KabamStore::stopMapping(const Value&) {
  const bool may = isMapping();
  if (may) {
    state_ = ManagerState::Idle;
    mapping_until_s_ = robot_.time();
    ++edits_.info, ++edits_.picture;
  }
  return triggered(may, "stop", "stopped");
}

Value KabamStore::saveMap(const Value& request) {
  const std::string& name = request["map_name"].text();
  const auto saved = [](SaveResult result, std::string_view id = {}) {
    return Value::Object{{"result", static_cast<int>(result)}, {"map_id", id}};
  };
  if (!mapping_since_s_ || !isUsable(name) || name.find('/') != std::string::npos)
    return saved(SaveResult::Invalid);
  if (maps_.size() >= kMostMaps) return saved(SaveResult::Failed);
  if (byName(maps_, name) != nullptr) return saved(SaveResult::NameExists);
  KabamMap map;
  map.id = newId();
  map.name = map.label = name;
  map.created_s = map.updated_s = robot_.time();
  map.spec = mappedUntil(isMapping() ? robot_.time() : mapping_until_s_);
  maps_.push_back(std::move(map));
  ++edits_.lists;
  if (!isMapping()) mapping_since_s_.reset();
  return saved(SaveResult::Saved, maps_.back().id);
}

Value KabamStore::loadMap(const Value& request) {
  const std::string &id = request["map_id"].text(), &at = request["loc_waypoint_name"].text();
  const KabamMap* map = mapOf(id);
  if (isMapping() || id.empty()) return resultOf(LoadResult::Invalid);
  if (map == nullptr) return resultOf(LoadResult::NoSuchMap);
  if (map->id == current_) return resultOf(LoadResult::AlreadyLoaded);
  const auto serves = [&](const KabamWaypoint& waypoint) {
    return waypoint.name == at &&
           std::find(waypoint.tags.begin(), waypoint.tags.end(), "localisation") != waypoint.tags.end();
  };
  if (map->archived || (!at.empty() && std::none_of(map->waypoints.begin(), map->waypoints.end(), serves)))
    return resultOf(LoadResult::Invalid);
  current_ = map->id;
  state_ = ManagerState::Active;
  ++edits_.info, ++edits_.waypoints, ++edits_.picture;
  return resultOf(LoadResult::Loaded);
}

Value KabamStore::deleteMap(const Value& request) {
  if (isMapping() || (options_.kabam_needs_flags && !request["delete_map"].flag()))
    return resultOf(UpdateResult::Invalid);
  const KabamMap* map = mapOf(request["map_id"].text());
  if (map == nullptr) return resultOf(UpdateResult::NoSuchMap);
  if (map->id == current_) return resultOf(UpdateResult::Invalid);
  maps_.erase(maps_.begin() + (map - maps_.data()));
  ++edits_.lists;
  return resultOf(UpdateResult::Deleted);
}

Value KabamStore::archiveMap(const Value& request) {
  if (isMapping()) return resultOf(UpdateResult::Invalid);
  KabamMap* map = mapOf(request["map_id"].text());
  if (map == nullptr) return resultOf(UpdateResult::NoSuchMap);
  const bool archived = request["set_archive"].flag();
  if (archived && map->id == current_) return resultOf(UpdateResult::Invalid);
  map->archived = archived;
  touch(*map);
  ++edits_.lists;
  return resultOf(UpdateResult::Updated);
}

Value KabamStore::renameMap(const Value& request) {
  const std::string& label = request["new_map_label"].text();
  if (isMapping() || !isUsable(label)) return resultOf(UpdateResult::Invalid);
  KabamMap* map = mapOf(request["map_id"].text());
  if (map == nullptr) return resultOf(UpdateResult::NoSuchMap);
  const bool taken = std::any_of(maps_.begin(), maps_.end(), [&](const KabamMap& other) {
    return &other != map && other.label == label;
  });
  if (taken) return resultOf(UpdateResult::Invalid);
  map->label = label;
  touch(*map);
  ++edits_.lists;
  return resultOf(UpdateResult::Updated);
}

Value KabamStore::updateMapImage(const Value& request) {
  if (isMapping()) return resultOf(UpdateResult::Invalid);
  KabamMap* map = mapOf(request["map_id"].text());
  if (map == nullptr) return resultOf(UpdateResult::NoSuchMap);
  const std::shared_ptr<const FloorCells> cells = pictures_.cells(map->spec);
  const Value& image = request["updated_image"];
  const auto width = static_cast<std::size_t>(image["width"].number());
  const auto height = static_cast<std::size_t>(image["height"].number());
  const auto step = static_cast<std::size_t>(image["step"].number());
  const auto* data = image["data"].as<Value::Bytes>();
  if (!cells || image["encoding"].text() != "mono8" || static_cast<int>(width) != cells->width ||
      static_cast<int>(height) != cells->height || step < width || data == nullptr ||
      data->data.size() != step * height)
    return resultOf(UpdateResult::Invalid);
  GrayPicture picture{cells->width, cells->height, {}};
  for (std::size_t row = 0; row < height; ++row) {
    const auto from = data->data.begin() + static_cast<std::ptrdiff_t>(row * step);
    picture.levels.insert(picture.levels.end(), from, from + static_cast<std::ptrdiff_t>(width));
  }
  setImage(*map, std::move(picture));
  return resultOf(UpdateResult::Updated);
}

void KabamStore::setImage(KabamMap& map, GrayPicture image) {
  map.image = std::make_shared<const GrayPicture>(std::move(image));
  map.picture_edits = ++picture_edits_;
  touch(map);
  if (map.id == current_) ++edits_.picture;
}

void KabamStore::otherPainter() {
  constexpr int kSpot = 6;
  const std::lock_guard lock(mutex_);
  KabamMap* const map = mapOf(current_);
  const std::shared_ptr<const FloorCells> cells = map != nullptr ? pictures_.cells(map->spec) : nullptr;
  if (!cells || cells->width < 4 * kSpot || cells->height < 4 * kSpot) return;
  GrayPicture picture{cells->width, cells->height, {}};
  if (map->image) {
    picture = *map->image;
  } else {
    for (const FloorCell cell : cells->cells) {
      const int shade = cell == FloorCell::Unknown ? 205 : cell == FloorCell::Free ? 254 : 0;
      picture.levels.push_back(static_cast<std::uint8_t>(shade));
    }
  }
  Dice dice(hashOf(seed_, 131, spots_++));
  const int left = dice.integer(0, cells->width - kSpot);
  const int top = dice.integer(0, cells->height - kSpot);
  for (int row = top; row < top + kSpot; ++row) {
    const auto at = picture.levels.begin() + std::ptrdiff_t{row} * cells->width + left;
    std::fill(at, at + kSpot, std::uint8_t{0});
  }
  setImage(*map, std::move(picture));
}

Value KabamStore::response(WaypointResult result, Value waypoint) {
  if (waypoint.isNull()) {
    KabamWaypoint none;
    none.pose = Value::Object{{"position", xyz(0, 0, 0)}, {"orientation", quaternion(0, 0)}};
    waypoint = waypointMessage(none, {});
  }
  return Value::Object{{"result", static_cast<int>(result)}, {"waypoint_response", std::move(waypoint)}};
}

void KabamStore::readTags(KabamWaypoint& waypoint, const Value& info) const {
  const auto* tags = info["waypoint_tags"].as<Value::List>();
  if (tags == nullptr || (tags->empty() && options_.kabam_empty_tags_keep)) return;
  waypoint.tags.clear();
  for (const Value& tag : *tags) waypoint.tags.push_back(tag.text());
}

Value KabamStore::createWaypoint(const Value& request) {
  const Value& info = request["waypoint_info"];
  KabamMap* map = mapOf(info["map_id"].text());
  if (map == nullptr) return response(WaypointResult::NoSuchMap);
  const std::string& name = info["name"].text();
  if (name.empty() || map->waypoints.size() >= kMostWaypoints) return response(WaypointResult::Failed);
  if (isTaken(*map, name)) return response(WaypointResult::NameExists);
  KabamWaypoint waypoint{name, newId(), info["frame_id"].text(), info["pose"], {}};
  readTags(waypoint, info);
  map->waypoints.push_back(std::move(waypoint));
  touch(*map);
  ++edits_.waypoints;
  return response(WaypointResult::Created, waypointMessage(map->waypoints.back(), map->id));
}

Value KabamStore::changed(const Value& request, const WaypointChange& change) {
  const Value& info = request["waypoint_info"];
  const std::string &map_id = info["map_id"].text(), &id = info["id"].text();
  // Only creating needs the map's id: without it, the waypoint's own has to do.
  if (!map_id.empty() && mapOf(map_id) == nullptr) return response(WaypointResult::NoSuchMap);
  for (KabamMap& map : maps_) {
    KabamWaypoint* const waypoint =
        id.empty() || (!map_id.empty() && map.id != map_id) ? nullptr : byId(map.waypoints, id);
    if (waypoint == nullptr) continue;
    const WaypointResult result = change(map, *waypoint);
    if (result != WaypointResult::Updated && result != WaypointResult::Deleted) return response(result);
    Value shown = waypointMessage(*waypoint, map.id);
    if (result == WaypointResult::Deleted)
      map.waypoints.erase(map.waypoints.begin() + (waypoint - map.waypoints.data()));
    touch(map);
    ++edits_.waypoints;
    return response(result, std::move(shown));
  }
  return response(WaypointResult::NotFound);
}

Value KabamStore::deleteWaypoint(const Value& request) {
  if (options_.kabam_needs_flags && !request["delete_waypoint"].flag())
    return response(WaypointResult::Failed);
  return changed(request, [](const KabamMap&, KabamWaypoint&) { return WaypointResult::Deleted; });
}

Value KabamStore::renameWaypoint(const Value& request) {
  return changed(request, [&](const KabamMap& map, KabamWaypoint& waypoint) {
    const Value& info = request["waypoint_info"];
    const std::string& name = info["name"].text();
    if (name.empty()) return WaypointResult::Failed;
    if (isTaken(map, name, &waypoint)) return WaypointResult::NameExists;
    waypoint.name = name;
    readTags(waypoint, info);
    return WaypointResult::Updated;
  });
}

Value KabamStore::repositionWaypoint(const Value& request) {
  return changed(request, [&](const KabamMap&, KabamWaypoint& waypoint) {
    const Value& info = request["waypoint_info"];
    waypoint.frame_id = info["frame_id"].text();
    waypoint.pose = info["pose"];
    readTags(waypoint, info);
    return WaypointResult::Updated;
  });
}

Value KabamStore::getWaypoint(const Value& request) {
  const KabamMap* map = mapOf(request["map_id"].text());
  const Value found =
      waypointList(map != nullptr ? *map : KabamMap{}, faults_.faults().ros, request["waypoint_id"].text());
  return Value::Object{{"waypoints", found}};
}

void KabamStore::otherOperator() {
  const std::lock_guard lock(mutex_);
  KabamMap* map = mapOf(current_);
  if (map == nullptr) return;
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

Value waypointList(const KabamMap& map, const RosFaults& faults, std::string_view id) {
  Value::List list;
  for (std::size_t i = 0; i < map.waypoints.size(); ++i) {
    if (!id.empty() && map.waypoints[i].id != id) continue;
    Value shown = waypointMessage(map.waypoints[i], map.id);
    Value pose = shown["pose"];
    if (faults.zero_quaternion && i % 3 != 0)  // or one that is not normalised
      pose.set("orientation", i % 3 == 1 ? quaternion(0, 0) : quaternion(2, 2));
    if (faults.nan_pose && i % 4 == 2) pose.set("position", poseOf({}, faults)["position"]);
    shown.set("pose", std::move(pose));
    list.push_back(std::move(shown));
  }
  return Value::Object{{"waypoints", std::move(list)}};
}

}  // namespace mapwright::simulator::ros
