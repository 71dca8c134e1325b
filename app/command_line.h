// One program for the window and its headless twin (docs/command-line.md).
#pragma once

namespace mapwright::app {

/// What `mapwright` was asked for on its command line. Returns the exit code; throws nothing.
int commandLine(int argc, char** argv);

}  // namespace mapwright::app
