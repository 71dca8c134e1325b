// Whether there is a screen to open a window on.
#pragma once

#include <memory>

#include <QApplication>
#include <QTemporaryDir>

#include "app/language.h"

namespace mapwright::app {

/// Chooses the Qt platform before QApplication exists: the user's choice, or else the screen in the
/// environment, with "offscreen" as the fallback.
void chooseWindowPlatform();
/// After QApplication exists: false if a screen was wanted but there is none.
bool haveDisplay();

/// After QApplication exists: characters of the language that the window's fonts lack come from a font for
/// it, in its own forms (Chinese, Japanese and Korean share most characters and write them differently).
/// False: there is none.
bool addLettersOf(const QString& language);

/// After QApplication exists: names on maps are drawn with the DejaVu Sans that the program carries.
void addLabelFont();

struct PinnedFonts {
  std::unique_ptr<QTemporaryDir> settings;  // null: they lie in the cache
};

/// For everything that needs no screen: offscreen, with letters that depend neither on the user's settings
/// nor on the files of DejaVu that are installed.
class OffscreenApplication : InPlaceOfSpeaker, PinnedFonts, public QApplication {
 public:
  OffscreenApplication(int& argc, char** argv);
};

}  // namespace mapwright::app
