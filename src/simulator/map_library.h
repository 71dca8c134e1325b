// The maps and mapping tasks that the simulated robot keeps, and which map it works with.
#pragma once

#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "simulator/map_pictures.h"
#include "simulator/robot_state.h"

namespace mapwright::simulator {

struct StoredMap {
  int id = 0;
  std::string uid, name;
  std::int64_t created_s = 0, modified_s = 0;  // epoch
  int map_version = 1, overlays_version = 1;
  PictureWish wish;
};

struct MappingTask {
  int id = 0;
  std::string state;  // finished, cancelled, failed
  std::int64_t started_s = 0;
  std::optional<std::int64_t> ended_s;
  std::optional<PictureWish> wish;  // what it made
};

/// Safe from any thread. A pure function of the scene and of what was changed since.
class MapLibrary {
 public:
  explicit MapLibrary(const RobotState& state) : state_(state), pictures_(state.scene()) {}

  std::vector<StoredMap> maps() const;  // empty for a scene without any submaps
  std::optional<StoredMap> find(int id) const;
  std::optional<StoredMap> current() const;
  std::vector<MappingTask> mappings() const;

  /// false when there is no such map.
  bool setCurrent(int id);
  /// The current map gets another picture and version.
  void change();
  /// Grows with every change of the above.
  std::uint64_t edits() const;

  MapPictures& pictures() { return pictures_; }
  const Scene& scene() const { return state_.scene(); }
  /// The current map as /map shows it, 4 bits. Null when there is none.
  MapPicturePtr livePicture();

  /// Keeps a picture for /static-files/; returns its path without a leading slash. The last 32 stay.
  std::string publishStatic(std::string_view prefix, const MapPicturePtr& picture);
  /// By the file's name: "map-<hash>.png". Null when it is not there (any more).
  MapPicturePtr staticFile(std::string_view name) const;

 private:
  std::vector<StoredMap> mapsNow() const;

  const RobotState& state_;
  MapPictures pictures_;
  mutable std::mutex mutex_;
  int current_ = 1;
  int changes_ = 0;
  std::uint64_t edits_ = 0;
  std::deque<std::pair<std::string, MapPicturePtr>> static_files_;
};

}  // namespace mapwright::simulator
