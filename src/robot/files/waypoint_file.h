// The waypoints of a local map: a GeoJSON FeatureCollection next to its map.yaml, with Point features in
// metres of the map (not in degrees, as GeoJSON requires). Pure functions, any thread.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "robot/waypoint_store.h"

namespace mapwright::robot::files {

inline constexpr std::size_t kMaxWaypointBytes = std::size_t(64) << 20;
inline constexpr std::size_t kMaxWaypoints = 100'000;

/// "office.yaml", "/maps/office.png" -> "office.waypoints.geojson" in the same folder.
std::string waypointPathOf(const std::string& map_path);

/// Reads Point features: coordinates [x, y] in metres; properties id, name, type (text), yaw_rad (a number),
/// tags (texts). Anything else in the file is kept. A feature without an id is identified by its name, one
/// with a duplicate id by its index. The error follows "cannot be read: ", without a full stop.
tl::expected<StoredWaypoints, Fault> parseWaypoints(std::string_view json);

/// The file with these changes. Unchanged and foreign features, unknown members and the order stay exactly as
/// they are. Empty `json` = there is no file yet.
tl::expected<std::string, Fault> patchWaypoints(std::string_view json,
                                                const std::vector<WaypointChange>& changes);

}  // namespace mapwright::robot::files
