// Makes robots from addresses: the only place that knows every back-end.
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

/// The address schemes of all kinds of robots that this program supports.
robot::Addresses knownAddresses();

/// Makes the robot that `address` names, not yet connected. `access` is for this address. The error is a
/// sentence.
tl::expected<std::unique_ptr<robot::Robot>, QString> makeRobot(const QString& address, const Access& access,
                                                               DemoTime demo_time);

/// The local files that a map is read from, including the map.yaml of a picture; none for a robot.
std::vector<std::string> sourceFilesOf(const QString& address, const std::string& id,
                                       const std::string& picture);

/// whyNoPlace says why --resolution and --origin do not apply to this address; nullopt if they do, or are not
/// given. placedFile adds the resolution (metres per cell) and origin ("x,y" or "x,y,yaw") to the address of
/// a plain picture; makeRobot() checks them later. Other addresses and empty values change nothing.
std::optional<QString> whyNoPlace(const QString& address, const std::string& resolution,
                                  const std::string& origin);
QString placedFile(const QString& address, const std::string& resolution, const std::string& origin);

/// The folder of cached HTTP answers (XDG_CACHE_HOME/mapwright/http).
QString httpCacheFolder();
/// The folder of cached pyramids of large maps (XDG_CACHE_HOME/mapwright/grids).
QString gridCacheFolder();
/// The folder of unsaved drafts (XDG_DATA_HOME/mapwright/drafts).
QString draftsFolder();

}  // namespace mapwright::app
