// `mapwright maps …`: the catalogue of a robot or a folder, exports and differences (docs/command-line.md).
#pragma once

#include <string>

#include "app/robot_access.h"

namespace mapwright::app {

/// The words as typed; empty = not given.
struct MapsWords {
  std::string robot;
  AccessWords access;
  std::string id;             // show, export: a map (12, mapping:48, live, submaps)
  std::string label;          // rename, save: what it is called from now on
  std::string place;          // load: the name of the waypoint where the robot stands
  std::string first, second;  // diff: a map of the robot, or a file
  std::string output, format, diff_picture, report;
  std::string resolution, origin;  // of a bare picture file; of exported submaps: the resolution
  std::string region;              // export: X,Y,LX,LY
  std::string filename;            // save-on-robot
  double timeout_s = 60;
  bool json = false, world_file = false;
  bool force = false;  // also over a file that is read
  bool yes = false;    // delete: it may go
};

/// The exit code (docs/command-line.md).
int mapsList(const MapsWords& words, int& argc, char** argv);
int mapsShow(const MapsWords& words, int& argc, char** argv);
int mapsCurrent(const MapsWords& words, int& argc, char** argv);
int mapsExport(const MapsWords& words, int& argc, char** argv);
int mapsSaveOnRobot(const MapsWords& words, int& argc, char** argv);
int mapsDiff(const MapsWords& words, int& argc, char** argv);

}  // namespace mapwright::app
