// `mapwright waypoints …`: the waypoints of one map of a robot or a folder (docs/command-line.md, "mapwright
// waypoints").
#pragma once

#include <string>
#include <vector>

#include "app/robot_access.h"

namespace mapwright::app {

/// The options as typed; empty = not given.
struct WaypointsWords {
  std::string robot;
  AccessWords access;
  std::string map;  // the id of a stored map; empty = the current one
  std::string report;
  double timeout_s = 60;
  bool json = false;
  bool dry_run = false;                  // print the changes, send nothing
  std::vector<std::string> which;        // get, rename, move, tag, delete: ids, or unique names
  std::string name;                      // create, rename: from now on
  std::string at;                        // create, move: X,Y or X,Y,YAW in metres and degrees
  std::string tags;                      // create, tag: a,b
  std::string added_tags, removed_tags;  // tag
  bool no_tags = false;                  // tag: all go
  bool yes = false;                      // delete: confirmed
  std::string file, format, output;      // import, plan, apply; export: csv or geojson; export, plan
  bool force = false;                    // also overwrite a source file, or apply to another robot
  bool warnings = false;                 // list: with warnings about each
  std::string radius;  // list, plan: distance to walls in metres; empty = the robot's footprint
  bool stop_at_failure = false, go_on = false;  // apply, import
};

/// The exit code (docs/command-line.md) of each.
int waypointsList(const WaypointsWords& words, int& argc, char** argv);
int waypointsGet(const WaypointsWords& words, int& argc, char** argv);
int waypointsExport(const WaypointsWords& words, int& argc, char** argv);
int waypointsCreate(const WaypointsWords& words, int& argc, char** argv);
int waypointsRename(const WaypointsWords& words, int& argc, char** argv);
int waypointsMove(const WaypointsWords& words, int& argc, char** argv);
int waypointsTag(const WaypointsWords& words, int& argc, char** argv);
int waypointsDelete(const WaypointsWords& words, int& argc, char** argv);
int waypointsImport(const WaypointsWords& words, int& argc, char** argv);
int waypointsPlan(const WaypointsWords& words, int& argc, char** argv);
int waypointsApply(const WaypointsWords& words, int& argc, char** argv);

}  // namespace mapwright::app
