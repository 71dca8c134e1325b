#include "simulator/map_library.h"

#include <algorithm>
#include <cmath>

#include "simulator/map_overlays.h"
#include "simulator/noise.h"
#include "simulator/stamp.h"

namespace mapwright::simulator {
namespace {

constexpr std::size_t kStaticFilesKept = 32;

PictureSpec wishFor(int trajectory, double resolution_m) {
  PictureSpec spec;
  spec.trajectory = trajectory;
  spec.resolution_m = resolution_m;
  return spec;
}

std::vector<StoredMap> mapsAtFirst(const Scene& scene) {
  if (scene.trajectories.empty()) return {};
  struct Kept {
    int id;
    const char *uid, *name;
    std::int64_t created_s, modified_s;
    int map_version, overlays_version, trajectory;
    double resolution_m;
  };
  const Kept kept[] = {
      {1, "62a1e0b4c9d84f5a9b7f3c21", "Ground floor", 1717405200, 1719911622, 3, 5, 0, 0.05},
      {2, "620620f9c0fd0ecb0f66d981", "前台大厅 2层", 1643007028, 1647333821, 9, 14, 3, 0.05},
      {7, "61e95264c0fd0ecb0f66c71e", "<b>Lager</b> & \"Ost\" 🏭", 1642680851, 1642680851, 1, 1, 2, 0.1},
      {12, "65f01c3ad2a54c0b8e5d7a90", "Ground floor", 1710234567, 1710234567, 1, 2, 0, 0.1}};
  std::vector<StoredMap> maps;
  for (const Kept& one : kept) {
    StoredMap map;
    map.id = one.id;
    map.uid = one.uid;
    map.name = one.name;
    map.created_s = one.created_s;
    map.modified_s = one.modified_s;
    map.map_version = one.map_version;
    map.overlays_version = one.overlays_version;
    map.overlays = std::make_shared<const std::string>(overlaysAlong(scene, one.trajectory));
    map.spec = wishFor(one.trajectory, one.resolution_m);
    maps.push_back(std::move(map));
  }
  return maps;
}

}  // namespace

MapLibrary::MapLibrary(const RobotState& state, std::uint32_t seed)
    : state_(state), seed_(seed), pictures_(state.scene()), maps_(mapsAtFirst(state.scene())) {
  if (maps_.empty()) return;
  current_ = at_first_ = maps_.front();
  next_id_ = maps_.back().id + 1;
}

std::int64_t MapLibrary::nowS() const {
  return static_cast<std::int64_t>(std::floor(stampOf(state_.time())));
}

std::string MapLibrary::uidFor(int number) const {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string uid;
  Dice dice(hashOf(seed_, 83, number));
  for (int i = 0; i < 24; ++i) uid += kDigits[dice.next() & 15];
  return uid;
}

StoredMap* MapLibrary::stored(int id) {
  const auto found =
      std::find_if(maps_.begin(), maps_.end(), [&](const StoredMap& map) { return map.id == id; });
  return found == maps_.end() ? nullptr : &*found;
}

std::vector<StoredMap> MapLibrary::maps() const {
  const std::lock_guard lock(mutex_);
  return maps_;
}

std::optional<StoredMap> MapLibrary::find(int id) const {
  for (StoredMap& map : maps()) {
    if (map.id == id) return std::move(map);
  }
  return std::nullopt;
}

std::optional<StoredMap> MapLibrary::current() const {
  const std::lock_guard lock(mutex_);
  return current_;
}

std::optional<StoredMap> MapLibrary::add(StoredMap map) {
  const std::int64_t now_s = nowS();
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
  map.modified_s = std::max(map.modified_s + 1, nowS());
}

std::optional<StoredMap> MapLibrary::patch(int id, const MapPatch& patch) {
  const std::lock_guard lock(mutex_);
  StoredMap* map = stored(id);
  if (map == nullptr) return std::nullopt;
  touch(*map, patch);
  if (current_ && current_->id == id) {
    current_ = *map;
    ++edits_.info;
  }
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

bool MapLibrary::setCurrent(int id) {
  const std::lock_guard lock(mutex_);
  const StoredMap* map = stored(id);
  if (map != nullptr) work(*map);
  return map != nullptr;
}

bool MapLibrary::setCurrent(std::string_view uid) {
  const std::lock_guard lock(mutex_);
  for (const StoredMap& map : maps_) {
    if (map.uid != uid) continue;
    work(map);
    return true;
  }
  return false;
}

void MapLibrary::setCurrentFromData(StoredMap map) {
  map.created_s = map.modified_s = nowS();
  const std::lock_guard lock(mutex_);
  map.id = -1;
  if (map.uid.empty()) map.uid = uidFor(-++handed_in_);
  work(map);
}

bool MapLibrary::setCurrentOverlays(std::string overlays) {
  const std::lock_guard lock(mutex_);
  if (!current_) return false;
  touch(*current_, {std::nullopt, std::move(overlays)});
  if (StoredMap* map = stored(current_->id)) *map = *current_;
  ++edits_.info;
  return true;
}

void MapLibrary::change() {
  const std::lock_guard lock(mutex_);
  if (!current_) return;
  ++current_->map_version;
  current_->modified_s += 60;
  if (current_->spec) ++current_->spec->crates;
  if (StoredMap* map = stored(current_->id)) *map = *current_;
  ++edits_.info;
  ++edits_.pictures;
}

MapEdits MapLibrary::edits() const {
  const std::lock_guard lock(mutex_);
  return edits_;
}

MapPicturePtr MapLibrary::pictureOf(const StoredMap& map) {
  return map.spec ? pictures_.picture(*map.spec) : map.picture;
}

MapPicturePtr MapLibrary::thumbnailOf(const StoredMap& map) {
  return map.spec ? pictures_.thumbnail(*map.spec) : map.thumbnail;
}

MapPicturePtr MapLibrary::livePicture() {
  std::optional<StoredMap> map = current();
  if (!map) return nullptr;
  if (map->spec) map->spec->bits = 4;
  return pictureOf(*map);
}

std::string MapLibrary::publishStatic(std::string_view prefix, const MapPicturePtr& picture) {
  const std::string name = std::string(prefix) + "-" + picture->hash + ".png";
  const std::lock_guard lock(mutex_);
  const bool known = std::any_of(static_files_.begin(), static_files_.end(),
                                 [&](const auto& file) { return file.first == name; });
  if (!known) static_files_.emplace_back(name, picture);
  if (static_files_.size() > kStaticFilesKept) static_files_.pop_front();
  return "static-files/" + name;
}

MapPicturePtr MapLibrary::staticFile(std::string_view name) const {
  const std::lock_guard lock(mutex_);
  for (const auto& [known, picture] : static_files_) {
    if (known == name) return picture;
  }
  return nullptr;
}

}  // namespace mapwright::simulator
