// mapwright simulate: the embedded robot on its own (cli.md).
#pragma once

#include "simulator/simulator.h"

namespace mapwright::app {

/// Serves until SIGINT or SIGTERM; prints one JSON line with the addresses when ready. Returns an exit code.
int simulate(const simulator::Options& options);

}  // namespace mapwright::app
