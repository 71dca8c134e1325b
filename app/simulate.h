// mapwright simulate: the embedded robot on its own (docs/command-line.md).
#pragma once

#include <string>

#include "simulator/simulator.h"

namespace mapwright::app {

struct SimulateWords {
  simulator::Options options;
  std::string secret_file;
};

/// Serves until SIGINT or SIGTERM; prints one JSON line with the addresses when ready. Returns an exit code.
int simulate(const SimulateWords& words);

}  // namespace mapwright::app
