// The waypoints of one map of a robot, as read by a command: the files that they come from and go to,
// warnings about them on their map, and previews of changes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QJsonArray>
#include <QString>
#include <tl/expected.hpp>

#include "app/robot_command.h"
#include "disk/file_error.h"
#include "exchange/wanted_waypoint.h"
#include "exchange/waypoint_plan.h"
#include "placing/warnings.h"
#include "robot/waypoint_store.h"

namespace mapwright::app {

/// The options as typed; empty = not given.
struct WaypointsArguments : RobotArguments {
  std::string map;                       // the id of a stored map; empty = the current one
  bool dry_run = false;                  // print the changes, send nothing
  std::vector<std::string> which;        // get, rename, move, tag, delete: ids, or unique names
  std::string name;                      // create, rename: from now on
  std::string at;                        // create, move: X,Y or X,Y,YAW in metres and degrees
  std::string tags;                      // create, tag: a,b
  std::string added_tags, removed_tags;  // tag
  bool no_tags = false;                  // tag: all go
  bool yes = false;                      // delete: confirmed
  std::string file, format, output;      // import, plan, apply; export: csv or geojson; export, plan
  std::string angles;                    // import, plan: degrees or radians; empty = guess
  bool force = false;                    // also overwrite a source file, or apply to another robot
  bool warnings = false;                 // list: with warnings about each
  std::string radius;  // list, plan: distance to walls in metres; empty = the robot's footprint
  bool stop_at_failure = false, go_on = false;  // apply, import
};

struct ListedWaypoints {
  RobotReading* robot = nullptr;  // not null
  map::MapKey map;
  robot::StoredWaypoints stored = {};
  robot::WaypointStore* store = nullptr;  // null = read-only

  std::string mapId() const { return map::toText(map); }
};

/// The edits as they will be stored; notes what cannot be.
std::vector<exchange::WaypointEdit> fitted(const ListedWaypoints& list,
                                           std::vector<exchange::WaypointEdit> edits);

enum class Use { Reading, Changing };
/// Connects and reads the waypoints of the map `map` ("" = the current one). With Changing, a robot without a
/// WaypointStore is refused.
CommandResult<ListedWaypoints> listWaypoints(RobotCommand& command, const std::string& map, Use use);
/// The same of a robot that is connected.
CommandResult<ListedWaypoints> listWaypoints(RobotReading& reading, const std::string& map, Use use);

/// Finds a waypoint by its id, or by its name if only one has it.
CommandResult<const map::Waypoint*> chosen(const ListedWaypoints& list, const std::string& word);

enum class WaypointFileKind { GeoJson, Csv };
/// By `format` ("csv", "geojson"), otherwise by the extension; "-" is GeoJSON. The error is a sentence.
tl::expected<WaypointFileKind, QString> waypointFileKind(const std::string& path, const std::string& format);

/// Parses the file by its name, or by `format` ("csv", "geojson", "yaml"); the standard input ("-") by what
/// it looks like. `angles`: "degrees", "radians" or empty, for headings without a unit. The error is a
/// sentence with the name of the file.
exchange::WantedFile readWantedFile(const std::string& path, const std::string& format,
                                    const std::string& angles);

struct DoubtfulWaypoints {
  std::vector<placing::Warnings> of;  // one entry per waypoint, in the same order
  /// What cannot be checked, and why, as a sentence; empty = everything was checked.
  QString untold;
  /// The map below them was checked.
  bool looked = false;
};
/// Opens the map of `list`, waiting at most some seconds, and checks `points` on it. `radius_m`: warn of
/// walls that are closer; nullopt = the robot's footprint, or else placing::kUsualRadiusM. Do not use the
/// robot for anything else afterwards.
DoubtfulWaypoints doubtsOf(const ListedWaypoints& list, const std::vector<map::Waypoint>& points,
                           std::optional<double> radius_m);

/// [{"kind","sentence"}], and "distance_m" and "radius_m" of near_wall; kinds are in_wall, outside_map,
/// near_wall, on_unknown, name_twice, zero_turn (docs/json.md).
QJsonArray warningsJson(const placing::Warnings& warnings);
/// One line with all warnings, most severe first.
QString warningsLine(const placing::Warnings& warnings);

/// A warning about a waypoint as it will be.
struct DoubtAhead {
  std::string id, name;  // the id is empty if it has none yet
  placing::Warnings warnings;
};
using DoubtsAhead = std::vector<DoubtAhead>;

/// printPreview() for a report, with the map.
QJsonObject previewReport(const ListedWaypoints& list, const exchange::MergedEdits& edits,
                          const std::optional<DoubtsAhead>& doubts = {});
/// {"changes","calls","conflicts"}, "refused" [{"id"|null,"name"}] if a name would be refused, and "warnings"
/// [{"id"|null,"name","warnings"}] if they were checked; or a table.
void printPreview(const ListedWaypoints& list, const exchange::MergedEdits& edits, bool json,
                  const std::optional<DoubtsAhead>& doubts = {});
/// The requests that would be sent to the store, without those that it is certain to refuse.
QJsonArray callsOf(const ListedWaypoints& list, const std::vector<exchange::WaypointEdit>& edits);

}  // namespace mapwright::app
