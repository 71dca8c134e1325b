// The window, and the demo window.
#pragma once

#include <QString>

#include "app/robot_access.h"

namespace mapwright::app {

/// Opens the window; `address` empty = not connected. Returns the exit code.
int window(const QString& address, const AccessWords& words, int& argc, char** argv);

/// The window on the embedded simulator; without a display it writes mapwright-demo.png and prints its name.
int demo(const QString& query, int& argc, char** argv);

}  // namespace mapwright::app
