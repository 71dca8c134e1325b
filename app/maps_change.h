// `mapwright maps rename` and `maps load`: what changes something on the robot (cli.md).
#pragma once

#include "app/maps.h"

namespace mapwright::app {

/// The exit code (cli.md). What the robot makes of it is printed as it tells it afterwards.
int mapsRename(const MapsWords& words, int& argc, char** argv);
int mapsLoad(const MapsWords& words, int& argc, char** argv);

}  // namespace mapwright::app
