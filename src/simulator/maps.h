// The maps stored on the simulated robot with its current one, and the mapping tasks that make them.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simulator/pictures.h"
#include "simulator/robot_state.h"
#include "simulator/state_file.h"

namespace mapwright::simulator {

/// A value; what is large in it is shared and never changes.
struct StoredMap {
  int id = 0;  // -1: set as the current map from data, not kept
  std::string uid, name;
  std::int64_t created_s = 0, modified_s = 0;  // epoch
  int map_version = 1, overlays_version = 1;
  std::shared_ptr<const std::string> overlays = {};  // GeoJSON as it was written, byte for byte; may be empty
  std::optional<PictureSpec> spec = {};              // drawn from the building,
  MapPicturePtr picture = {}, thumbnail = {};        // or handed in
  std::shared_ptr<const std::string> carto_map = {};  // what the robot positions itself by
};

/// One without any features.
std::string noOverlays();
/// Whether a text is valid as a map's overlays: a JSON object with a list of features, or empty.
bool isOverlays(std::string_view text);

/// The changes that a client may make to a map; absent members stay.
struct MapPatch {
  std::optional<std::string> name, overlays;
};

/// Counters of changes; each only increases.
struct MapEdits {
  std::uint64_t info = 0;      // the content of /map/info for the current map
  std::uint64_t pictures = 0;  // the robot's current map, and its picture
  bool operator==(const MapEdits&) const = default;
};

/// Safe from any thread. A pure function of scene, seed and later changes.
class MapLibrary {
 public:
  MapLibrary(const RobotState& state, MapPictures& pictures, std::uint32_t seed);

  std::vector<StoredMap> maps() const;  // empty for a scene without submaps
  std::optional<StoredMap> find(int id) const;
  std::optional<StoredMap> current() const;
  /// The current map before any change: recordings were made with it.
  const std::optional<StoredMap>& atFirst() const { return at_first_; }

  /// Stores a new map under the next id; creates a uid if it has none. nullopt if its uid is taken.
  std::optional<StoredMap> add(StoredMap map);
  /// nullopt if there is no such map.
  std::optional<StoredMap> patch(int id, const MapPatch& patch);
  /// If the current map is removed the robot continues with it; its id is -1 then.
  bool remove(int id);
  void removeAll();
  /// false if there is no such map; by its uid where one is given.
  bool setCurrent(int id, std::string_view uid = {});
  /// Uses a map without storing it.
  void setCurrentFromData(StoredMap map);
  /// The overlays of the current map; false if there is none.
  bool setCurrentOverlays(std::string overlays);
  /// Somebody else changes its overlays: the first time there is one more, later that gets another name.
  void editOverlays(int id);
  /// The current map gets another picture and version.
  void change();
  MapEdits edits() const;

  MapPictures& pictures() { return pictures_; }
  const Scene& scene() const { return state_.scene(); }
  /// Null if it is empty.
  MapPicturePtr pictureOf(const StoredMap& map) {
    return map.spec ? pictures_.picture(*map.spec) : map.picture;
  }
  MapPicturePtr thumbnailOf(const StoredMap& map) {
    return map.spec ? pictures_.thumbnail(*map.spec) : map.thumbnail;
  }
  /// What the robot positions itself by on the map of `picture`, which may be null; made once.
  std::shared_ptr<const std::string> stateFile(const MapPicturePtr& picture) {
    return state_files_.get(picture ? picture->hash : std::string(),
                            [&] { return std::make_shared<const std::string>(stateFileOf(picture)); });
  }
  /// The current map as in /map, with 4 bits if the robot drew it. Null if there is none.
  MapPicturePtr livePicture();

  /// Stores a picture for /static-files/; returns its path without a leading slash. The last 32 are kept.
  std::string publishStatic(std::string_view prefix, const MapPicturePtr& picture);
  /// By file name: "map-<hash>.png". Null if it does not exist (any more).
  MapPicturePtr staticFile(std::string_view name) {
    return static_files_.find(std::string(name)).value_or(nullptr);
  }

 private:
  std::string uidFor(int number) const;
  void touch(StoredMap& map, const MapPatch& patch);
  /// A map as it is now, stored and current.
  void keep(const StoredMap& map);
  void work(const StoredMap& map);

  const RobotState& state_;
  const std::uint32_t seed_;
  MapPictures& pictures_;
  Cache<std::string, std::shared_ptr<const std::string>> state_files_{8};  // by the hash of the picture
  mutable std::mutex mutex_;
  std::vector<StoredMap> maps_;       // ascending by id
  std::optional<StoredMap> current_;  // its present state; for a stored one always the same as the stored one
  std::optional<StoredMap> at_first_;
  int next_id_ = 1;
  int handed_in_ = 0;
  MapEdits edits_;
  Cache<std::string, MapPicturePtr> static_files_{32};
};

struct MappingTask {
  int id = 0;
  std::string state;  // running, finished, cancelled, failed
  bool continues = false;
  std::int64_t started_s = 0;
  std::optional<std::int64_t> ended_s;
  std::optional<PictureSpec> spec;  // what it made
};

/// What a mapping has seen so far; `new_only` excludes the map that it continues.
PictureSpec specOf(const MappingSpan& span, bool new_only);

/// Safe from any thread. While a task runs, the robot's SLAM session is that mapping.
class MappingTasks {
 public:
  explicit MappingTasks(RobotState& state);

  std::vector<MappingTask> tasks() const;  // newest first
  std::optional<MappingTask> find(int id) const;
  std::optional<MappingTask> running() const;

  /// nullopt if one is already running.
  std::optional<MappingTask> start(Mapping mapping);
  enum class End { Finished, FinishedNewOnly, Cancelled };
  /// nullopt when none runs.
  std::optional<MappingTask> end(End how);

  /// One that does not run.
  void remove(int id);
  /// false, with nothing removed, while one is running.
  bool removeAll();

 private:
  bool runs() const { return !tasks_.empty() && tasks_.front().state == "running"; }

  RobotState& state_;
  mutable std::mutex mutex_;
  std::vector<MappingTask> tasks_;
  int next_id_ = 1;
};

}  // namespace mapwright::simulator
