// The words of `mapwright maps …` on the command line.
#pragma once

#include "app/maps.h"

namespace CLI {
class App;
}

namespace mapwright::app {

/// The subcommand and its own ones; `words` outlives them.
void addMaps(CLI::App& cli, MapsWords& words);
/// The one that was given; the exit code.
int runMaps(const CLI::App& cli, const MapsWords& words, int& argc, char** argv);

}  // namespace mapwright::app
