// `mapwright record`: what a robot sends, into an MCAP file (docs/command-line.md; recorder/layout.h).
#pragma once

#include <optional>
#include <string>

#include "app/robot_access.h"

namespace CLI {
class App;
}

namespace mapwright::app {

/// The words as typed; empty = not given.
struct RecordWords {
  std::string robot;
  AccessWords access;
  std::string output;
  std::optional<double> duration_s;  // nullopt = until it is told to end
  double timeout_s = 30;             // for the connection
  std::string topics;                // comma-separated, by the robot's own names, besides those of `streams`
  std::string streams = "all";       // comma-separated words of kinds of data, "all" or "none"
  std::string submaps = "listed";    // "all", "listed" or "none"
  bool json = false, force = false;
};

void addRecord(CLI::App& cli, RecordWords& words);

/// Until the time is over, or SIGINT or SIGTERM. The exit code (docs/command-line.md).
int record(const RecordWords& words, int& argc, char** argv);

}  // namespace mapwright::app
