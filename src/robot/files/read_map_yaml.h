// The map.yaml of ROS map_server and nav2 map_io.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "map/catalogue.h"

namespace mapwright::robot::files {

struct MapYaml {
  std::string image;        // as written: absolute, or relative to the file's folder
  map::GridReference grid;  // width and height 0
  map::CellReading reading;
  std::vector<Fault> notes;  // warnings
};

/// The maximum size.
inline constexpr std::size_t kMaxYamlBytes = std::size_t(1) << 20;

/// Reads image, resolution (m), origin [x, y, yaw] (m, rad), negate, occupied_thresh, free_thresh and mode;
/// other members are ignored. What map_server refuses is read with a note where only one meaning is possible
/// (an origin of two numbers, or with z and a quaternion; no negate; a yaw that is not a number becomes 0),
/// and otherwise refused. Pure, any thread.
tl::expected<MapYaml, Fault> parseMapYaml(const std::string& text);

/// The last read state of map.yaml files. Reads a file again only if it has changed: another inode, size or
/// time. A very recent change is not trusted, since a second one could have the same time. One thread.
class YamlShelf {
 public:
  /// `now_ns`: the time of day, by the clock used for file times.
  explicit YamlShelf(std::function<std::int64_t()> now_ns = &timeOfDayNs) : now_ns_(std::move(now_ns)) {}
  /// Never waits for a named pipe.
  tl::expected<MapYaml, Fault> read(const std::string& path);
  /// How often a file was really read, for tests.
  int reads() const { return reads_; }

 private:
  struct Stamp {
    std::uint64_t device = 0, inode = 0, size = 0;
    std::int64_t modified_ns = 0, changed_ns = 0;
    bool operator==(const Stamp&) const = default;
  };
  struct Kept {
    Stamp stamp;
    tl::expected<MapYaml, Fault> yaml;
  };
  static std::int64_t timeOfDayNs();
  std::function<std::int64_t()> now_ns_;
  std::unordered_map<std::string, Kept> kept_;
  int reads_ = 0;
};

}  // namespace mapwright::robot::files
