// From an address to a robot: the one place that knows every back-end.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <QString>
#include <tl/expected.hpp>

#include "app/demo_robot.h"
#include "app/robot_access.h"
#include "robot/address.h"
#include "robot/robot.h"

namespace mapwright::app {

/// The addresses of every kind of robot that this program knows.
robot::Addresses knownAddresses();

/// Makes the robot that `address` names, not yet connected. `access` is for this address. The error is a
/// sentence.
tl::expected<std::unique_ptr<robot::Robot>, QString> makeRobot(const QString& address, const Access& access,
                                                               DemoTime demo_time);

/// The local files that a map is read from, the map.yaml beside a picture included; none of a robot.
std::vector<std::string> sourceFilesOf(const QString& address, const std::string& id,
                                       const std::string& picture);

/// The address of a bare picture with its resolution (metres per cell) and origin ("x,y" or "x,y,yaw") from
/// the command line, which makeRobot() then checks; other addresses, and empty words, change nothing.
/// Why --resolution and --origin make no sense for this address; nullopt when they do, or are not given.
std::optional<QString> whyNoPlace(const QString& address, const std::string& resolution,
                                  const std::string& origin);
QString placedFile(const QString& address, const std::string& resolution, const std::string& origin);

/// The folder of answers kept on disk (XDG_CACHE_HOME/mapwright/http).
QString httpCacheFolder();
/// The folder of finished pyramids of large maps (XDG_CACHE_HOME/mapwright/grids).
QString gridCacheFolder();
/// The folder of what was changed and is not saved yet (XDG_DATA_HOME/mapwright/drafts).
QString draftsFolder();

}  // namespace mapwright::app
