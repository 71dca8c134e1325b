// mapwright snapshot (docs/command-line.md): a picture of a robot's map without a window.
#pragma once

#include "app/snapshot_options.h"

namespace CLI {
class App;
}

namespace mapwright::app {

class Commands;

/// Runs to the end and returns the exit code. Makes its own QApplication, offscreen.
int snapshot(const SnapshotWords& words, int& argc, char** argv);

/// `bags snapshot` and `bags film`; see Commands.
void addBagPictures(Commands& commands, CLI::App& bags);

}  // namespace mapwright::app
