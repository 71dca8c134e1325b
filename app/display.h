// Whether there is a screen to open a window on.
#pragma once

#include <memory>

#include <QApplication>
#include <QTemporaryDir>

namespace mapwright::app {

/// Chooses the Qt platform before QApplication exists: the user's choice, or else the screen in the
/// environment, with "offscreen" as the fallback.
void chooseWindowPlatform();
/// After QApplication exists: false if a screen was wanted but there is none.
bool haveDisplay();

/// After QApplication exists: names on maps are drawn with the DejaVu Sans that the program carries.
void addLabelFont();

struct PinnedFonts {
  std::unique_ptr<QTemporaryDir> settings;  // null: they lie in the cache
};

/// For everything that needs no screen: offscreen, with letters that depend neither on the user's settings
/// nor on the files of DejaVu that are installed.
class OffscreenApplication : PinnedFonts, public QApplication {
 public:
  OffscreenApplication(int& argc, char** argv);
};

}  // namespace mapwright::app
