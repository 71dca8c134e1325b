// The words of `mapwright waypoints …` on the command line.
#pragma once

#include "app/waypoints.h"

namespace CLI {
class App;
}

namespace mapwright::app {

/// The subcommand and its own ones; `words` outlives them.
void addWaypoints(CLI::App& cli, WaypointsWords& words);
/// The one that was given; the exit code.
int runWaypoints(const CLI::App& cli, const WaypointsWords& words, int& argc, char** argv);

}  // namespace mapwright::app
