// The map that a command is about, what lies below its things, and the files that are handed in.
#pragma once

#include <optional>
#include <string>

#include <QString>
#include <tl/expected.hpp>

#include "app/robot_command.h"
#include "disk/file_error.h"
#include "placing/ground.h"

namespace mapwright::app {

/// It is one segment of a path, and means nothing else there: a request without an id may mean all maps.
bool isPlainId(const std::string& id);
/// `--map`: the id of a stored map, of local ones also a name; "" = the current map, or the only one.
CommandResult<map::MapKey> storedMap(RobotReading& robot, const std::string& id);

struct MapBelow {
  placing::PlacedMap map;      // without cells: it could not be loaded
  QString unavailable_reason;  // a sentence
};
/// Opens a map, waiting at most some seconds. Do not use the robot for anything else afterwards.
MapBelow mapBelow(RobotReading& reading, const map::MapKey& key);

/// `--radius` in metres; nullopt = not given. The error is a sentence.
tl::expected<std::optional<double>, QString> radiusFrom(const std::string& word);
/// The radius that the robot reports, waiting a moment for it, or else placing::kUsualRadiusM.
double robotRadius(RobotReading& reading);

/// The bytes of a file, or of the standard input ("-"); reads slightly more than `most` if there is more.
tl::expected<std::string, disk::FileError> bytesOf(const std::string& path, std::size_t most);
inline bool isStandardInput(const std::string& path) { return path == "-"; }
/// What messages call it.
QString inputCalled(const std::string& path);

}  // namespace mapwright::app
