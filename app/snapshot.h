// mapwright snapshot (docs/command-line.md): a picture of a robot's map without a window.
#pragma once

#include "app/snapshot_options.h"

namespace mapwright::app {

/// Runs to the end and returns the exit code. Makes its own QApplication, offscreen.
int snapshot(const SnapshotWords& words, int& argc, char** argv);

}  // namespace mapwright::app
