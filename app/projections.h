// `mapwright projections …`: what of a map in space is laid on the plane; and maps that a robot writes into a
// file of its own. Source: docs/protocols/rep130-map-dispatcher.md.
#pragma once

#include <string>
#include <vector>

#include "app/robot_access.h"

namespace CLI {
class App;
}

namespace mapwright::app {

/// The words as typed; empty = not given.
struct ProjectionsWords {
  std::string robot;
  AccessWords access;
  std::vector<std::string> wanted;  // X,Y,WIDTH,HEIGHT,MIN_Z,MAX_Z or the same with ,FRAME
  std::string report;
  double timeout_s = 60;
  bool json = false;
  bool none = false;  // nothing is to be projected
};

/// The subcommand and its own ones; `words` outlives them.
void addProjections(CLI::App& cli, ProjectionsWords& words);
/// The one that was given; the exit code (docs/command-line.md).
int runProjections(const CLI::App& cli, const ProjectionsWords& words, int& argc, char** argv);

}  // namespace mapwright::app
