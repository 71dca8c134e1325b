// One program for the window and its headless twin (docs/command-line.md).
#pragma once

namespace mapwright::app {

/// Runs the `mapwright` command line. Returns the exit code; does not throw.
int commandLine(int argc, char** argv);

}  // namespace mapwright::app
