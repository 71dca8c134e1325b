#include "simulator/ros/kabam_store.h"

#include <algorithm>
#include <cmath>

#include "simulator/noise.h"
#include "simulator/ros/shapes.h"

namespace mapwright::simulator::ros {
namespace {

constexpr double kScansPerS = kSpeedMPerS / kScanStepM;
constexpr int kScansAtStart = 8;
constexpr std::size_t kMostMaps = 1000;
constexpr double kDayS = 86'400;

bool isUsable(std::string_view name) { return !name.empty() && name.size() <= 255; }

}  // namespace

Value waypointMessage(const KabamWaypoint& waypoint, std::string_view map_id) {
  Value::List tags(waypoint.tags.begin(), waypoint.tags.end());
  return Value::Object{{"name", waypoint.name}, {"id", waypoint.id}, {"frame_id", waypoint.frame_id},
                       {"pose", waypoint.pose}, {"map_id", map_id},  {"waypoint_tags", std::move(tags)}};
}

KabamStore::KabamStore(const RobotState& state, MapPictures& pictures, const RosOptions& options,
                       std::uint32_t seed)
    : robot_(state), pictures_(pictures), options_(options), seed_(seed) {
  if (!state.scene().trajectories.empty()) furnish(std::clamp(options.waypoints, 0, 100'000));
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
    map.spec.trajectory = one.trajectory;
    map.spec.resolution_m = one.resolution_m;
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
    const bool has_name = at < std::size(named);
    first.waypoints.push_back(waypointAt(first, 2 + step * i,
                                         has_name ? named[at].name : "Waypoint " + std::to_string(i + 1),
                                         has_name ? named[at].tags : std::vector<std::string>()));
  }
  if (waypoints > 3) first.waypoints[3].frame_id.clear();  // as some managers send it
  current_ = first.id;
  state_ = ManagerState::Active;
}

std::string KabamStore::newId() {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string id;
  Dice dice(hashOf(seed_, 97, ids_++));
  for (int i = 0; i < 32; ++i) {
    if (i == 8 || i == 12 || i == 16 || i == 20) id += '-';
    id += kDigits[dice.next() & 15];
  }
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
  for (const KabamMap& map : maps_) {
    if (!current_.empty() && map.id == current_) return map;
  }
  return std::nullopt;
}

KabamEdits KabamStore::edits() const {
  const std::lock_guard lock(mutex_);
  return edits_;
}

std::optional<RasterSource> KabamStore::raster() const {
  const std::lock_guard lock(mutex_);
  if (state_ == ManagerState::Mapping) {
    RasterSource source;
    source.spec.trajectory = 1;
    source.spec.from_m = kSpeedMPerS * *mapping_since_s_;
    source.spec.scans =
        kScansAtStart + static_cast<int>(kScansPerS * std::floor(robot_.time() - *mapping_since_s_));
    return source;
  }
  for (const KabamMap& map : maps_) {
    if (!current_.empty() && map.id == current_)
      return RasterSource{map.id, map.picture_edits, map.spec, map.image};
  }
  return std::nullopt;
}

KabamMap* KabamStore::mapOf(std::string_view id) {
  const auto found =
      std::find_if(maps_.begin(), maps_.end(), [&](const KabamMap& map) { return map.id == id; });
  return found == maps_.end() ? nullptr : &*found;
}

void KabamStore::touch(KabamMap& map) {
  map.updated_s = robot_.time();
  if (map.id == current_) ++edits_.info;
}

bool KabamStore::startMapping() {
  const std::lock_guard lock(mutex_);
  if (state_ == ManagerState::Mapping || !robot_.canMap()) return false;
  state_ = ManagerState::Mapping;
  mapping_since_s_ = robot_.time();
  current_.clear();
  ++edits_.info, ++edits_.waypoints, ++edits_.picture;
  return true;
}

bool KabamStore::stopMapping() {
  const std::lock_guard lock(mutex_);
  if (state_ != ManagerState::Mapping) return false;
  state_ = ManagerState::Idle;
  mapping_until_s_ = robot_.time();
  ++edits_.info, ++edits_.picture;
  return true;
}

SaveResult KabamStore::save(const std::string& name, std::string& id) {
  const std::lock_guard lock(mutex_);
  if (!mapping_since_s_ || !isUsable(name) || name.find('/') != std::string::npos) return SaveResult::Invalid;
  if (maps_.size() >= kMostMaps) return SaveResult::Failed;
  const bool taken =
      std::any_of(maps_.begin(), maps_.end(), [&](const KabamMap& map) { return map.name == name; });
  if (taken) return SaveResult::NameExists;
  KabamMap map;
  id = map.id = newId();
  map.name = map.label = name;
  map.created_s = map.updated_s = robot_.time();
  map.spec.trajectory = 1;
  map.spec.from_m = kSpeedMPerS * *mapping_since_s_;
  const double until_s = state_ == ManagerState::Mapping ? robot_.time() : mapping_until_s_;
  map.spec.scans = kScansAtStart + static_cast<int>(kScansPerS * std::floor(until_s - *mapping_since_s_));
  maps_.push_back(std::move(map));
  ++edits_.lists;
  if (state_ != ManagerState::Mapping) mapping_since_s_.reset();
  return SaveResult::Saved;
}

LoadResult KabamStore::load(const std::string& id, const std::string& loc_waypoint_name) {
  const std::lock_guard lock(mutex_);
  const KabamMap* map = mapOf(id);
  if (state_ == ManagerState::Mapping || id.empty()) return LoadResult::Invalid;
  if (map == nullptr) return LoadResult::NoSuchMap;
  if (map->id == current_) return LoadResult::AlreadyLoaded;
  if (map->archived) return LoadResult::Invalid;
  const auto serves = [&](const KabamWaypoint& waypoint) {
    return waypoint.name == loc_waypoint_name &&
           std::find(waypoint.tags.begin(), waypoint.tags.end(), "localisation") != waypoint.tags.end();
  };
  if (!loc_waypoint_name.empty() && std::none_of(map->waypoints.begin(), map->waypoints.end(), serves))
    return LoadResult::Invalid;
  current_ = map->id;
  state_ = ManagerState::Active;
  ++edits_.info, ++edits_.waypoints, ++edits_.picture;
  return LoadResult::Loaded;
}

UpdateResult KabamStore::remove(const std::string& id, bool flag) {
  const std::lock_guard lock(mutex_);
  if (state_ == ManagerState::Mapping || (options_.kabam_needs_flags && !flag)) return UpdateResult::Invalid;
  const KabamMap* map = mapOf(id);
  if (map == nullptr) return UpdateResult::NoSuchMap;
  if (map->id == current_) return UpdateResult::Invalid;
  maps_.erase(maps_.begin() + (map - maps_.data()));
  ++edits_.lists;
  return UpdateResult::Deleted;
}

UpdateResult KabamStore::archive(const std::string& id, bool archived) {
  const std::lock_guard lock(mutex_);
  if (state_ == ManagerState::Mapping) return UpdateResult::Invalid;
  KabamMap* map = mapOf(id);
  if (map == nullptr) return UpdateResult::NoSuchMap;
  if (archived && map->id == current_) return UpdateResult::Invalid;
  map->archived = archived;
  touch(*map);
  ++edits_.lists;
  return UpdateResult::Updated;
}

UpdateResult KabamStore::relabel(const std::string& id, const std::string& label) {
  const std::lock_guard lock(mutex_);
  if (state_ == ManagerState::Mapping || !isUsable(label)) return UpdateResult::Invalid;
  KabamMap* map = mapOf(id);
  if (map == nullptr) return UpdateResult::NoSuchMap;
  const bool taken = std::any_of(maps_.begin(), maps_.end(), [&](const KabamMap& other) {
    return &other != map && other.label == label;
  });
  if (taken) return UpdateResult::Invalid;
  map->label = label;
  touch(*map);
  ++edits_.lists;
  return UpdateResult::Updated;
}

UpdateResult KabamStore::replaceImage(const std::string& id, const Value& image) {
  std::optional<KabamMap> map;
  {
    const std::lock_guard lock(mutex_);
    if (state_ == ManagerState::Mapping) return UpdateResult::Invalid;
    if (const KabamMap* found = mapOf(id)) map = *found;
  }
  if (!map) return UpdateResult::NoSuchMap;
  const std::shared_ptr<const FloorCells> cells = pictures_.cells(map->spec);  // may take a while
  const auto width = static_cast<std::size_t>(image["width"].number());
  const auto height = static_cast<std::size_t>(image["height"].number());
  const auto step = static_cast<std::size_t>(image["step"].number());
  const auto* data = image["data"].as<Value::Bytes>();
  if (!cells || image["encoding"].text() != "mono8" || static_cast<int>(width) != cells->width ||
      static_cast<int>(height) != cells->height || step < width || data == nullptr ||
      data->data.size() != step * height)
    return UpdateResult::Invalid;
  auto picture = std::make_shared<GrayPicture>();
  picture->width = static_cast<int>(width);
  picture->height = static_cast<int>(height);
  for (std::size_t row = 0; row < height; ++row) {
    const auto from = data->data.begin() + static_cast<std::ptrdiff_t>(row * step);
    picture->levels.insert(picture->levels.end(), from, from + static_cast<std::ptrdiff_t>(width));
  }
  const std::lock_guard lock(mutex_);
  KabamMap* kept = mapOf(id);
  if (kept == nullptr) return UpdateResult::NoSuchMap;
  kept->image = std::move(picture);
  kept->picture_edits = ++picture_edits_;
  touch(*kept);
  if (kept->id == current_) ++edits_.picture;
  return UpdateResult::Updated;
}

void KabamStore::otherPainter() {
  constexpr int kSpot = 6;
  const std::optional<KabamMap> map = current();
  const std::shared_ptr<const FloorCells> cells = map ? pictures_.cells(map->spec) : nullptr;
  if (!cells || cells->width < 4 * kSpot || cells->height < 4 * kSpot) return;
  auto picture = std::make_shared<GrayPicture>();
  if (map->image) {
    *picture = *map->image;
  } else {
    *picture = {cells->width, cells->height, {}};
    for (const FloorCell cell : cells->cells) {
      const int shade = cell == FloorCell::Unknown ? 205 : cell == FloorCell::Free ? 254 : 0;
      picture->levels.push_back(static_cast<std::uint8_t>(shade));
    }
  }
  const std::lock_guard lock(mutex_);
  KabamMap* kept = mapOf(map->id);
  if (kept == nullptr || kept->picture_edits != map->picture_edits) return;
  Dice dice(hashOf(seed_, 131, spots_++));
  const int left = dice.integer(0, cells->width - kSpot);
  const int top = dice.integer(0, cells->height - kSpot);
  for (int row = top; row < top + kSpot; ++row) {
    const auto at = picture->levels.begin() + std::ptrdiff_t{row} * cells->width + left;
    std::fill(at, at + kSpot, std::uint8_t{0});
  }
  kept->image = std::move(picture);
  kept->picture_edits = ++picture_edits_;
  touch(*kept);
  ++edits_.picture;
}

}  // namespace mapwright::simulator::ros
