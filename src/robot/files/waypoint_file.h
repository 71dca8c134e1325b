// The waypoints of a local map: a GeoJSON FeatureCollection beside its map.yaml, Point features in the metres
// of the map (not in degrees, which GeoJSON would have). Pure functions, any thread.
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

/// "office.yaml", "/maps/office.png" -> "office.waypoints.geojson" beside it.
std::string waypointPathOf(const std::string& map_path);

/// Reads Point features: coordinates [x, y] in metres; properties id, name, type (text), yaw_rad (a number),
/// tags (texts). What else is in the file is left alone. A feature without an id is told by its name, one
/// whose id has been met before by its turn. The error follows "cannot be read: ", without a full stop.
tl::expected<StoredWaypoints, Fault> parseWaypoints(std::string_view json);

/// The file with these changes made. Features that are not changed, foreign ones, unknown members of the file
/// and of features, and their order stay as they are, to the letter. Empty `json` = there is no file yet.
tl::expected<std::string, Fault> patchWaypoints(std::string_view json,
                                                const std::vector<WaypointChange>& changes);

}  // namespace mapwright::robot::files
