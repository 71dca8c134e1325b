// Exit codes of every subcommand (cli.md).
#pragma once

namespace mapwright::app {

enum ExitCode : int {
  kDone = 0,
  kIncomplete = 1,   // done, but not complete
  kUsage = 2,        // wrong usage or bad input file
  kUnreachable = 3,  // the robot cannot be reached or refused
  kRobotError = 4,   // the robot answered with an error for this request
};

}  // namespace mapwright::app
