// Whether there is a screen to open a window on.
#pragma once

#include <memory>

class QTemporaryDir;

namespace mapwright::app {

/// Chooses the Qt platform before QApplication exists: the user's own choice, else the screen that the
/// environment names with "offscreen" to fall back on.
void chooseWindowPlatform();
/// For everything that needs no screen: offscreen, and fonts that do not depend on the user's settings. What
/// it returns (maybe null) has to live as long as QApplication.
[[nodiscard]] std::unique_ptr<QTemporaryDir> chooseOffscreenPlatform();
/// After QApplication exists: false when a screen was wanted and there is none.
bool haveDisplay();

}  // namespace mapwright::app
