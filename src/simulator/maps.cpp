#include "simulator/maps.h"

#include <algorithm>
#include <cmath>

#include "simulator/noise.h"
#include "simulator/value.h"

namespace mapwright::simulator {
namespace {

using Eigen::Vector2d;

constexpr int kLiveTrajectory = 1, kFinishedMap = 0, kGatehouse = 3;

std::int64_t wholeStamp(const RobotState& state) {
  return static_cast<std::int64_t>(std::floor(stampOf(state.time())));
}

/// Puts features one after the other.
class Collection {
 public:
  void add(const char* shape, Value coordinates, Value::Object properties, bool with_id = true) {
    Value feature;
    if (with_id) feature.set("id", "65a0000000000000000000" + std::to_string(10 + features_.size()));
    feature.set("type", "Feature");
    feature.set("geometry", Value::Object{{"type", shape}, {"coordinates", std::move(coordinates)}});
    feature.set("properties", std::move(properties));
    features_.push_back(std::move(feature));
  }
  void point(const geometry::Pose2& at, Value::Object properties, bool with_id = true) {
    add("Point", pointOf({at.x_m, at.y_m}), std::move(properties), with_id);
  }
  void line(const std::vector<Vector2d>& points, Value::Object properties) {
    add("LineString", pointsOf(points), std::move(properties));
  }
  void ring(const std::vector<Vector2d>& points, Value::Object properties) {
    add("Polygon", Value::List{pointsOf(points)}, std::move(properties));
  }
  std::string finished() const {
    return toJson(Value::Object{{"type", "FeatureCollection"}, {"features", features_}});
  }

 private:
  Value::List features_;
};

/// A rectangle around a place on the way, in its direction; closed as GeoJSON wants unless `open`.
std::vector<Vector2d> box(const geometry::Pose2& at, double length, double width, bool open = false) {
  std::vector<Vector2d> ring = cornersOf(at, length, width);
  if (!open) ring.push_back(ring.front());
  return ring;
}

Value yawOf(const geometry::Pose2& pose, bool as_text) {
  const Value yaw = fixed(geometry::degreesFromRadians(pose.yaw_rad), 2);
  return as_text ? Value(toJson(yaw)) : yaw;
}

/// The overlays of a stored map (docs/protocols/autoxing.md, "Overlays"): every kind of feature, points with
/// a yaw as number and as text, lines, regions, an open ring, unknown kinds. Placed along a trajectory.
std::string overlaysAlong(const Scene& scene, int id) {
  Collection all;
  const Trajectory* way = scene.find(id);
  if (way == nullptr) return all.finished();
  const double step = way->drive.length_m() / 40;
  const auto at = [&](int i) { return way->drive.at(step * i); };

  const std::pair<int, const char*> kinds[] = {{9, "Charger"},
                                               {36, "Docking point"},
                                               {6, "Elevator A"},
                                               {10, "Standby"},
                                               {11, "Table 1"},
                                               {11, "餐桌 2"},
                                               {19, "Reception <main>"},
                                               {25, "Waypoint"},
                                               {27, "Exchange"},
                                               {28, "Wait for the elevator"},
                                               {29, "Dispatch"},
                                               {34, "Rack 🏭"},
                                               {3, "Other"},
                                               {77, "Nobody knows"}};
  int place = 1;
  for (const auto& [number, name] : kinds) {
    const Value type = place % 3 == 0 ? Value(std::to_string(number)) : Value(number);
    Value::Object properties{{"type", type}, {"yaw", yawOf(at(place), place % 2 == 0)}, {"name", name}};
    if (place == 1) properties.emplace_back("dockingPointId", "65a000000000000000000011");
    if (place == 3) properties.emplace_back("deviceIds", Value::List{"el-1", "el-2"});
    all.point(at(place), std::move(properties), place != 7);
    ++place;
  }
  all.point(at(16), {{"type", "37"}, {"barcodeId", "D2_125"}, {"name", ""}, {"yaw", yawOf(at(16), true)}});
  all.point(at(17), {{"type", 39}, {"landmarkId", "landmark_1"}});

  const auto between = [&](int from, int to) {
    std::vector<Vector2d> points;
    for (int i = from; i <= to; ++i) points.push_back(at(i).apply({0, 0}));
    return points;
  };
  all.line(between(1, 3), {{"lineType", "1"}, {"name", "Track"}, {"lineName", "Track"}});
  all.line({at(18).apply({-1, 0.9}), at(18).apply({1, 0.9}), at(18).apply({1.4, 0.5})},
           {{"lineType", "2"}, {"name", "Virtual wall"}});
  all.line(between(20, 21), {{"lineType", 3}});
  all.line(between(22, 24), {{"lineType", 4}, {"name", "Patrol"}});
  all.line(between(24, 25), {{"lineType", 88}});

  int region_place = 20;
  for (const int region : {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 13, 15, 16, 17, 99}) {
    Value::Object properties{{"regionType", region}, {"name", "Region " + std::to_string(region)}};
    if (region == 2) properties.emplace_back("speed", 0.4);
    if (region == 4 || region == 5) properties.emplace_back("mac", "30:AE:A4:00:11:22");
    // Robots leave some rings open.
    all.ring(box(at(region_place), 1.6, 1.1, region == 12 || region == 8), std::move(properties));
    ++region_place;
  }
  // A ring with a hole, a collection of shapes that no robot draws, and a feature without a place.
  all.add("Polygon", Value::List{pointsOf(box(at(37), 2.4, 1.8)), pointsOf(box(at(37), 1.0, 0.6))},
          {{"regionType", 1}, {"name", "With a hole"}});
  all.add("MultiPoint", pointsOf(between(38, 39)),
          {{"type", 25}, {"future", Value::Json{R"({"a":[1,2,{"b":null}]})"}}});
  all.add("Polygon", Value::List{}, {{"regionType", 1}, {"name", "Empty"}});
  return all.finished();
}

std::vector<StoredMap> mapsAtFirst(const Scene& scene) {
  std::vector<StoredMap> maps;
  if (scene.trajectories.empty()) return maps;
  const auto add = [&](StoredMap map, int trajectory, double resolution_m) {
    map.overlays = std::make_shared<const std::string>(overlaysAlong(scene, trajectory));
    map.spec = {trajectory, resolution_m};
    maps.push_back(std::move(map));
  };
  add({1, "62a1e0b4c9d84f5a9b7f3c21", "Ground floor", 1717405200, 1719911622, 3, 5}, 0, 0.05);
  add({2, "620620f9c0fd0ecb0f66d981", "前台大厅 2层", 1643007028, 1647333821, 9, 14}, 3, 0.05);
  add({7, "61e95264c0fd0ecb0f66c71e", "<b>Lager</b> & \"Ost\" 🏭", 1642680851, 1642680851, 1, 1}, 2, 0.1);
  add({12, "65f01c3ad2a54c0b8e5d7a90", "Ground floor", 1710234567, 1710234567, 1, 2}, 0, 0.1);
  return maps;
}

}  // namespace

std::string noOverlays() { return Collection().finished(); }

bool isOverlays(std::string_view text) {
  if (text.empty()) return true;
  const std::optional<Value> overlays = fromJson(text);
  return overlays && (*overlays)["features"].as<Value::List>() != nullptr;
}

MapLibrary::MapLibrary(const RobotState& state, MapPictures& pictures, std::uint32_t seed)
    : state_(state), seed_(seed), pictures_(pictures), maps_(mapsAtFirst(state.scene())) {
  if (maps_.empty()) return;
  current_ = at_first_ = maps_.front();
  next_id_ = maps_.back().id + 1;
}

std::string MapLibrary::uidFor(int number) const { return hexDigits(hashOf(seed_, 83, number), 24); }

std::vector<StoredMap> MapLibrary::maps() const {
  const std::lock_guard lock(mutex_);
  return maps_;
}

std::optional<StoredMap> MapLibrary::find(int id) const {
  const std::lock_guard lock(mutex_);
  return copyOf(byId(maps_, id));
}

std::optional<StoredMap> MapLibrary::current() const {
  const std::lock_guard lock(mutex_);
  return current_;
}

std::optional<StoredMap> MapLibrary::add(StoredMap map) {
  const std::int64_t now_s = wholeStamp(state_);
  const std::lock_guard lock(mutex_);
  const bool taken = !map.uid.empty() && std::any_of(maps_.begin(), maps_.end(), [&](const StoredMap& known) {
    return known.uid == map.uid;
  });
  if (taken) return std::nullopt;
  map.id = next_id_++;
  if (map.uid.empty()) map.uid = uidFor(map.id);
  map.created_s = map.modified_s = now_s;
  maps_.push_back(map);
  return map;
}

void MapLibrary::touch(StoredMap& map, const MapPatch& patch) {
  if (patch.name) map.name = *patch.name;
  if (patch.overlays) {
    map.overlays = std::make_shared<const std::string>(*patch.overlays);
    ++map.overlays_version;
  }
  map.modified_s = std::max(map.modified_s + 1, wholeStamp(state_));
  keep(map);
}

void MapLibrary::keep(const StoredMap& map) {
  if (StoredMap* const stored = byId(maps_, map.id)) *stored = map;
  if (!current_ || current_->id != map.id) return;
  current_ = map;
  ++edits_.info;
}

std::optional<StoredMap> MapLibrary::patch(int id, const MapPatch& patch) {
  const std::lock_guard lock(mutex_);
  StoredMap* map = byId(maps_, id);
  if (map == nullptr) return std::nullopt;
  touch(*map, patch);
  return *map;
}

bool MapLibrary::remove(int id) {
  const std::lock_guard lock(mutex_);
  if (std::erase_if(maps_, [&](const StoredMap& map) { return map.id == id; }) == 0) return false;
  if (current_ && current_->id == id) current_->id = -1;
  return true;
}

void MapLibrary::removeAll() {
  const std::lock_guard lock(mutex_);
  maps_.clear();
  if (current_) current_->id = -1;
}

void MapLibrary::work(const StoredMap& map) {
  current_ = map;
  ++edits_.info;
  ++edits_.pictures;
}

bool MapLibrary::setCurrent(int id, std::string_view uid) {
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(maps_.begin(), maps_.end(), [&](const StoredMap& map) {
    return uid.empty() ? map.id == id : map.uid == uid;
  });
  if (found == maps_.end()) return false;
  work(*found);
  return true;
}

void MapLibrary::setCurrentFromData(StoredMap map) {
  map.created_s = map.modified_s = wholeStamp(state_);
  const std::lock_guard lock(mutex_);
  map.id = -1;
  if (map.uid.empty()) map.uid = uidFor(-++handed_in_);
  work(map);
}

bool MapLibrary::setCurrentOverlays(std::string overlays) {
  const std::lock_guard lock(mutex_);
  if (!current_) return false;
  touch(*current_, {std::nullopt, std::move(overlays)});
  return true;
}

void MapLibrary::editOverlays(int id) {
  const std::lock_guard lock(mutex_);
  StoredMap* const map = id < 0 && current_ ? &*current_ : byId(maps_, id);
  if (map == nullptr) return;
  std::string text = map->overlays && !map->overlays->empty() ? *map->overlays : noOverlays();
  const std::string_view name = R"("name":"Somebody )";
  const std::string number = std::to_string(map->overlays_version + 1);
  if (const auto at = text.find(name); at != std::string::npos) {
    const auto begin = at + name.size();
    text.replace(begin, text.find('"', begin) - begin, number);
  } else {
    const auto list = text.find('[', text.find(R"("features")"));
    if (list == std::string::npos) return;
    const auto next = text.find_first_not_of(" \t\r\n", list + 1);
    const bool any = next != std::string::npos && text[next] != ']';
    text.insert(list + 1,
                R"({"id":"somebody","type":"Feature","geometry":{"type":"Point","coordinates":[1.50,1.0]},)"
                R"("properties":{"type":"25",)" +
                    std::string(name) + number + "\"}}" + (any ? "," : ""));
  }
  touch(*map, {std::nullopt, std::move(text)});
}

void MapLibrary::change() {
  const std::lock_guard lock(mutex_);
  if (!current_) return;
  ++current_->map_version;
  current_->modified_s += 60;
  if (current_->spec) ++current_->spec->crates;
  keep(*current_);
  ++edits_.pictures;
}

MapEdits MapLibrary::edits() const {
  const std::lock_guard lock(mutex_);
  return edits_;
}

MapPicturePtr MapLibrary::livePicture() {
  std::optional<StoredMap> map = current();
  if (!map) return nullptr;
  if (map->spec) map->spec->bits = 4;
  return pictureOf(*map);
}

std::string MapLibrary::publishStatic(std::string_view prefix, const MapPicturePtr& picture) {
  const std::string name = std::string(prefix) + "-" + picture->hash + ".png";
  static_files_.get(name, [&] { return picture; });
  return "static-files/" + name;
}

PictureSpec specOf(const MappingSpan& span, bool new_only) {
  PictureSpec spec{.trajectory = kLiveTrajectory, .scans = span.scans, .from_m = span.from_m};
  if (span.mapping == Mapping::Continue && !new_only) spec.base = kFinishedMap;
  return spec;
}

MappingTasks::MappingTasks(RobotState& state) : state_(state) {
  if (state.scene().trajectories.empty()) return;
  tasks_ = {{48, "finished", false, 1717401600, 1717405100, PictureSpec{kFinishedMap}},
            {47, "cancelled", false, 1647494329, std::nullopt, std::nullopt},
            {31, "finished", false, 1643001000, 1643006900, PictureSpec{kGatehouse}},
            {30, "failed", false, 1643000000, 1643000100, std::nullopt}};
  next_id_ = tasks_.front().id + 1;
}

std::vector<MappingTask> MappingTasks::tasks() const {
  const std::lock_guard lock(mutex_);
  return tasks_;
}

std::optional<MappingTask> MappingTasks::find(int id) const {
  const std::lock_guard lock(mutex_);
  return copyOf(byId(tasks_, id));
}

std::optional<MappingTask> MappingTasks::running() const {
  const std::lock_guard lock(mutex_);
  if (!runs()) return std::nullopt;
  return tasks_.front();
}

std::optional<MappingTask> MappingTasks::start(Mapping mapping) {
  const std::lock_guard lock(mutex_);
  if (runs()) return std::nullopt;
  state_.setMapping(mapping);
  MappingTask task;
  task.id = next_id_++;
  task.state = "running";
  task.continues = mapping == Mapping::Continue;
  task.started_s = wholeStamp(state_);
  tasks_.insert(tasks_.begin(), task);
  return task;
}

std::optional<MappingTask> MappingTasks::end(End how) {
  const std::lock_guard lock(mutex_);
  const std::optional<MappingSpan> span = state_.mapping();
  if (!runs() || !span) return std::nullopt;
  MappingTask& task = tasks_.front();
  task.ended_s = wholeStamp(state_);
  task.state = how == End::Cancelled ? "cancelled" : "finished";
  if (how != End::Cancelled) task.spec = specOf(*span, how == End::FinishedNewOnly);
  state_.setMapping(Mapping::Off);
  return task;
}

void MappingTasks::remove(int id) {
  const std::lock_guard lock(mutex_);
  std::erase_if(tasks_, [&](const MappingTask& task) { return task.id == id; });
}

bool MappingTasks::removeAll() {
  const std::lock_guard lock(mutex_);
  if (runs()) return false;
  tasks_.clear();
  return true;
}

}  // namespace mapwright::simulator
