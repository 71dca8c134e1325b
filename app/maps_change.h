// `mapwright maps rename|load|archive|unarchive|delete|start-mapping|stop-mapping|save`: what changes
// something on the robot (docs/command-line.md).
#pragma once

#include "app/maps.h"
#include "robot/map_administration.h"

namespace mapwright::app {

/// The exit code (docs/command-line.md). Afterwards prints the result as the robot reports it.
int mapsChange(robot::MapChange change, const MapsWords& words, int& argc, char** argv);

}  // namespace mapwright::app
