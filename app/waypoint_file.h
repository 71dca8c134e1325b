// Waypoint files: their format, their content, and the files that a map's own waypoints are stored in.
#pragma once

#include <string>
#include <vector>

#include <QString>
#include <tl/expected.hpp>

#include "disk/file_error.h"
#include "exchange/wanted_waypoint.h"
#include "map/catalogue.h"

namespace mapwright::app {

enum class WaypointFileKind { GeoJson, Csv };
/// By `format` ("csv", "geojson"), otherwise by the extension; "-" is GeoJSON. The error is a sentence.
tl::expected<WaypointFileKind, QString> waypointFileKind(const std::string& path, const std::string& format);

/// The bytes of a file, or of the standard input ("-"); reads slightly more than `most` if there is more.
tl::expected<std::string, disk::FileError> bytesOf(const std::string& path, std::size_t most);
/// What messages call it.
QString inputCalled(const std::string& path);

/// Parses the file; "-" is the standard input, taken as GeoJSON if it begins with a brace. The error is a
/// sentence with the name of the file.
exchange::WantedFile readWantedFile(const std::string& path, const std::string& format);

/// The local files that the map `key` and its waypoints are read from; none for a robot.
std::vector<std::string> waypointSources(const std::string& address, const map::MapKey& key);

}  // namespace mapwright::app
