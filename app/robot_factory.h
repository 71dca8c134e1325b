// Makes robots from addresses: the only place that knows every back-end. Demos and recordings among them.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QString>
#include <QUrlQuery>
#include <tl/expected.hpp>

#include "app/robot_access.h"
#include "robot/address.h"
#include "robot/probe.h"
#include "robot/robot.h"
#include "session/session_options.h"
#include "simulator/simulator.h"

namespace mapwright::app {

/// Whether the demo's world runs, or stands still so that all snapshots are the same.
enum class DemoTime { Running, Frozen };

/// The address schemes of all kinds of robots that this program supports.
robot::Addresses knownAddresses();

/// The questions that tell which kinds of robots answer there.
std::vector<robot::Probe> probesOf(const robot::Host& host);

/// Makes the robot that `address` names, not yet connected. `access` is for this address. The error is a
/// sentence.
tl::expected<std::unique_ptr<robot::Robot>, QString> makeRobot(const QString& address, const Access& access,
                                                               DemoTime demo_time);

/// The local files that a map is read from, including the map.yaml of a picture, its waypoints and overlays;
/// none for a robot.
std::vector<std::string> sourceFilesOf(const QString& address, const std::string& id,
                                       const std::string& picture);

/// noPlaceReason says why --resolution and --origin do not apply to this address; nullopt if they do, or are
/// not given. placedFile adds the resolution (metres per cell) and origin ("x,y" or "x,y,yaw") to the address
/// of a plain picture; makeRobot() checks them later. Other addresses and empty values change nothing.
std::optional<QString> noPlaceReason(const QString& address, const std::string& resolution,
                                     const std::string& origin);
QString placedFile(const QString& address, const std::string& resolution, const std::string& origin);

/// What every session is made with: submaps are requested ahead, pyramids of large maps are cached
/// (XDG_CACHE_HOME/mapwright/grids).
session::Session::Options sessionOptions();

/// Parses the query of "demo:?scene=warehouse&submaps=500&seed=3" into simulator options; the error is a
/// sentence.
tl::expected<simulator::Options, QString> parseDemoQuery(const QUrlQuery& query, DemoTime time);

/// Starts a simulator on a free loopback port and a client connected to it.
tl::expected<std::unique_ptr<robot::Robot>, QString> makeDemoRobot(const QString& address,
                                                                   const simulator::Options& options);

/// `bag` is the bag or file as typed, `robot` the address given with it, `otherwise` the default address
/// (MAPWRIGHT_ROBOT, or given before the subcommand). If no robot is given and the file exists, it means the
/// file; with only a default robot, whose bags may have the same name, only if it is written as a path or
/// ends in .mcap. Then `robot` becomes the address of the file and `bag` its name there; otherwise an empty
/// `robot` becomes `otherwise`.
void onRecording(std::string& robot, std::string& bag, const std::string& otherwise);

/// Whether the file or folder at `path` is a recording, by its name or its first bytes.
bool isRecording(const QString& path);
/// The name of the bag in that recording.
std::string bagNameOf(const QString& path);
/// Why there is no map to be read from the robot at `address`; nullopt: it is no recording, or `bag` is one
/// that is replayed.
std::optional<QString> recordingWithoutTimeReason(const QString& address, const std::string& bag);
/// The path of the Cartographer state file (.pbstream) that an address names; nullopt: it names none.
std::optional<QString> stateFileOf(const QString& address);
/// Whether it is called like a map: .yaml, .yml, .png, .pgm or .bmp.
bool isMapFile(const QString& path);
/// The YAML files beside a single picture that name it; empty if it is not a picture.
QStringList yamlsNaming(const QString& picture);

/// True if it is an existing file, or written like a path or a recording's name.
bool isFileName(const QString& typed);

}  // namespace mapwright::app
