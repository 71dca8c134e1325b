// Files of waypoints: which kind they are, what they ask for, and which ones the waypoints themselves lie in.
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
/// By `format` ("csv", "geojson"), else by the end of the name; "-" is GeoJSON. The error is a sentence.
tl::expected<WaypointFileKind, QString> waypointFileKind(const std::string& path, const std::string& format);

/// The bytes of a file, or ("-") what comes by the standard input; a little more than `most` where there are
/// more.
tl::expected<std::string, disk::FileError> bytesOf(const std::string& path, std::size_t most);
/// What a sentence calls it.
QString inputCalled(const std::string& path);

/// What is in it; "-" is the standard input, GeoJSON where it begins with a brace. The error is a sentence
/// with the name of the file.
exchange::WantedFile readWantedFile(const std::string& path, const std::string& format);

/// The local files that the map `key` of this robot and its waypoints are read from; none of a robot.
std::vector<std::string> waypointSources(const std::string& address, const map::MapKey& key);

}  // namespace mapwright::app
