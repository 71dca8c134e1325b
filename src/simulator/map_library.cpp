#include "simulator/map_library.h"

#include <algorithm>

namespace mapwright::simulator {
namespace {

constexpr std::size_t kStaticFilesKept = 32;

PictureWish wishFor(int trajectory, double resolution_m) {
  PictureWish wish;
  wish.trajectory = trajectory;
  wish.resolution_m = resolution_m;
  return wish;
}

}  // namespace

std::vector<StoredMap> MapLibrary::mapsNow() const {
  if (state_.scene().trajectories.empty()) return {};
  std::vector<StoredMap> maps{
      {1, "62a1e0b4c9d84f5a9b7f3c21", "Ground floor", 1717405200, 1719911622, 3, 5, wishFor(0, 0.05)},
      {2, "620620f9c0fd0ecb0f66d981", "前台大厅 2层", 1643007028, 1647333821, 9, 14, wishFor(3, 0.05)},
      {7, "61e95264c0fd0ecb0f66c71e", "<b>Lager</b> & \"Ost\" 🏭", 1642680851, 1642680851, 1, 1,
       wishFor(2, 0.1)},
      {12, "65f01c3ad2a54c0b8e5d7a90", "Ground floor", 1710234567, 1710234567, 1, 2, wishFor(0, 0.1)}};
  for (StoredMap& map : maps) {
    if (map.id != 1) continue;
    map.map_version += changes_;
    map.modified_s += 60 * changes_;
    map.wish.crates = changes_;
  }
  return maps;
}

std::vector<StoredMap> MapLibrary::maps() const {
  const std::lock_guard lock(mutex_);
  return mapsNow();
}

std::optional<StoredMap> MapLibrary::find(int id) const {
  for (StoredMap& map : maps()) {
    if (map.id == id) return std::move(map);
  }
  return std::nullopt;
}

std::optional<StoredMap> MapLibrary::current() const {
  const std::lock_guard lock(mutex_);
  for (StoredMap& map : mapsNow()) {
    if (map.id == current_) return std::move(map);
  }
  return std::nullopt;
}

std::vector<MappingTask> MapLibrary::mappings() const {
  if (state_.scene().trajectories.empty()) return {};
  return {{48, "finished", 1717401600, 1717405100, wishFor(0, 0.05)},
          {47, "cancelled", 1647494329, std::nullopt, std::nullopt},
          {31, "finished", 1643001000, 1643006900, wishFor(3, 0.05)},
          {30, "failed", 1643000000, 1643000100, std::nullopt}};
}

bool MapLibrary::setCurrent(int id) {
  if (!find(id)) return false;
  const std::lock_guard lock(mutex_);
  current_ = id;
  ++edits_;
  return true;
}

void MapLibrary::change() {
  const std::lock_guard lock(mutex_);
  ++changes_;
  ++edits_;
}

std::uint64_t MapLibrary::edits() const {
  const std::lock_guard lock(mutex_);
  return edits_;
}

MapPicturePtr MapLibrary::livePicture() {
  const std::optional<StoredMap> map = current();
  if (!map) return nullptr;
  PictureWish wish = map->wish;
  wish.bits = 4;
  return pictures_.picture(wish);
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
