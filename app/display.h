// Whether there is a screen to open a window on.
#pragma once

#include <memory>

class QTemporaryDir;

namespace mapwright::app {

/// Chooses the Qt platform before QApplication exists: the user's choice, or else the screen in the
/// environment, with "offscreen" as the fallback.
void chooseWindowPlatform();
/// For everything that needs no screen: offscreen, with fonts that do not depend on the user's settings. The
/// result (may be null) must live as long as QApplication.
[[nodiscard]] std::unique_ptr<QTemporaryDir> chooseOffscreenPlatform();
/// After QApplication exists: false if a screen was wanted but there is none.
bool haveDisplay();

}  // namespace mapwright::app
