// The maps that the simulated robot keeps, and which of them it works with.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "simulator/map_pictures.h"
#include "simulator/robot_state.h"
#include "simulator/stored_map.h"

namespace mapwright::simulator {

/// What a program may change of a map; what is absent stays.
struct MapPatch {
  std::optional<std::string> name, overlays;
};

/// What has changed so far; each grows.
struct MapEdits {
  std::uint64_t info = 0;      // what /map/info tells of the current map
  std::uint64_t pictures = 0;  // which map the robot works with, and its picture
  bool operator==(const MapEdits&) const = default;
};

/// Safe from any thread. A pure function of the scene, the seed and of what was changed since.
class MapLibrary {
 public:
  MapLibrary(const RobotState& state, std::uint32_t seed);

  std::vector<StoredMap> maps() const;  // empty for a scene without any submaps
  std::optional<StoredMap> find(int id) const;
  std::optional<StoredMap> current() const;
  /// The current map as it was before anything was changed: what recordings were made with.
  const std::optional<StoredMap>& atFirst() const { return at_first_; }

  /// Keeps a new map under the next id; a uid is made where it has none. nullopt when its uid is taken.
  std::optional<StoredMap> add(StoredMap map);
  /// nullopt when there is no such map.
  std::optional<StoredMap> patch(int id, const MapPatch& patch);
  /// The robot goes on working with the current map when that is taken away; its id is -1 then.
  bool remove(int id);
  void removeAll();
  /// false when there is no such map.
  bool setCurrent(int id);
  bool setCurrent(std::string_view uid);
  /// Works with a map without keeping it.
  void setCurrentFromData(StoredMap map);
  /// The overlays of the current map; false when there is none.
  bool setCurrentOverlays(std::string overlays);
  /// The current map gets another picture and version.
  void change();
  MapEdits edits() const;

  MapPictures& pictures() { return pictures_; }
  const Scene& scene() const { return state_.scene(); }
  /// Null when there is nothing to see.
  MapPicturePtr pictureOf(const StoredMap& map);
  MapPicturePtr thumbnailOf(const StoredMap& map);
  /// The current map as /map shows it, 4 bits when the robot drew it. Null when there is none.
  MapPicturePtr livePicture();

  /// Keeps a picture for /static-files/; returns its path without a leading slash. The last 32 stay.
  std::string publishStatic(std::string_view prefix, const MapPicturePtr& picture);
  /// By the file's name: "map-<hash>.png". Null when it is not there (any more).
  MapPicturePtr staticFile(std::string_view name) const;

 private:
  std::int64_t nowS() const;
  std::string uidFor(int number) const;
  StoredMap* stored(int id);
  void touch(StoredMap& map, const MapPatch& patch);
  void work(const StoredMap& map);

  const RobotState& state_;
  const std::uint32_t seed_;
  MapPictures pictures_;
  mutable std::mutex mutex_;
  std::vector<StoredMap> maps_;       // ascending by id
  std::optional<StoredMap> current_;  // as it is; of a kept one always the same as the kept
  std::optional<StoredMap> at_first_;
  int next_id_ = 1;
  int handed_in_ = 0;
  MapEdits edits_;
  std::deque<std::pair<std::string, MapPicturePtr>> static_files_;
};

}  // namespace mapwright::simulator
