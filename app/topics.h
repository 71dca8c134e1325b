// `mapwright topics list|echo|hz`: what a robot sends, by its own names (docs/command-line.md).
#pragma once

#include <string>
#include <vector>

#include "app/robot_access.h"

namespace CLI {
class App;
}

namespace mapwright::app {

/// The words as typed; empty = not given.
struct TopicsWords {
  std::string robot;
  AccessWords access;
  std::vector<std::string> topics;
  int count = 0;          // of echo: messages; 0: until it is stopped
  double seconds = 10;    // of hz
  double timeout_s = 30;  // for the connection, and of echo for each message
  bool json = false;
};

void addTopics(CLI::App& cli, TopicsWords& words);

/// The exit code (docs/command-line.md).
int runTopics(const CLI::App& cli, const TopicsWords& words, int& argc, char** argv);

}  // namespace mapwright::app
