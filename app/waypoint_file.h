// Files of waypoints: which kind they are, what they ask for, and which ones the waypoints themselves lie in.
#pragma once

#include <string>
#include <vector>

#include <QString>
#include <tl/expected.hpp>

#include "app/wanted_waypoint.h"
#include "map/catalogue.h"

namespace mapwright::app {

enum class WaypointFileKind { GeoJson, Csv };
/// By `format` ("csv", "geojson"), else by the end of the name; "-" is GeoJSON. The error is a sentence.
tl::expected<WaypointFileKind, QString> waypointFileKind(const std::string& path, const std::string& format);

/// What is in it. The error is a sentence with the name of the file.
WantedFile readWantedFile(const std::string& path, const std::string& format);

/// The local files that the map `key` of this robot and its waypoints are read from; none of a robot.
std::vector<std::string> waypointSources(const std::string& address, const map::MapKey& key);

}  // namespace mapwright::app
