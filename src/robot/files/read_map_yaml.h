// The map.yaml of ROS map_server and nav2 map_io. Pure function, any thread.
#pragma once

#include <string>
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
/// other members are ignored. A yaw that is not a number becomes 0, with a note.
tl::expected<MapYaml, Fault> parseMapYaml(const std::string& text);

}  // namespace mapwright::robot::files
