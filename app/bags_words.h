// The words of `mapwright bags …` on the command line.
#pragma once

#include "app/bags.h"

namespace CLI {
class App;
}

namespace mapwright::app {

/// The subcommand and its own ones; `words` outlives them.
void addBags(CLI::App& cli, BagsWords& words);
/// The one that was given; the exit code.
int runBags(const CLI::App& cli, const BagsWords& words, int& argc, char** argv);

}  // namespace mapwright::app
