// `mapwright maps …`: the maps of a robot or a folder, exports and differences (docs/command-line.md).
#pragma once

#include <string>

#include "app/robot_access.h"

namespace mapwright::app {

/// The options as typed; empty = not given.
struct MapsWords {
  std::string robot;
  AccessWords access;
  std::string id;             // show, export: a map (12, mapping:48, live, submaps)
  std::string label;          // rename, save: the new name
  std::string place;          // load: the name of the waypoint where the robot stands
  std::string first, second;  // diff: a map of the robot, or a file
  std::string output, format, diff_picture, report;
  std::string resolution, origin;  // of a plain picture file; resolution also for exported submaps
  std::string region;              // export: X,Y,LX,LY
  std::string filename;            // save-on-robot
  double timeout_s = 60;
  bool json = false, world_file = false;
  bool force = false;  // overwrite files even if the map was read from them
  bool yes = false;    // delete: confirmed
};

/// The exit code (docs/command-line.md).
int mapsList(const MapsWords& words, int& argc, char** argv);
int mapsShow(const MapsWords& words, int& argc, char** argv);
int mapsCurrent(const MapsWords& words, int& argc, char** argv);
int mapsExport(const MapsWords& words, int& argc, char** argv);
int mapsSaveOnRobot(const MapsWords& words, int& argc, char** argv);
int mapsDiff(const MapsWords& words, int& argc, char** argv);

}  // namespace mapwright::app
