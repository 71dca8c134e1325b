// What can be said on the command line of mapwright simulate.
#pragma once

#include "app/simulate.h"

namespace CLI {
class App;
}

namespace mapwright::app {

/// Adds the subcommand; what is typed goes into `words`, which outlives `cli`.
void addSimulate(CLI::App& cli, SimulateWords& words);

}  // namespace mapwright::app
