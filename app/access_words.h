// The words of every command that speaks to a robot: secrets and certificates (docs/command-line.md).
#pragma once

#include "app/robot_access.h"

namespace CLI {
class App;
}

namespace mapwright::app {

/// --secret-file, --secret-file-for and --ca-file of `command`; `words` outlives it.
void addAccess(CLI::App& command, AccessWords& words);

}  // namespace mapwright::app
