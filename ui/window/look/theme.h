// Light, dark or as the system has it: palette and style sheet of the whole application.
#pragma once

#include <QString>

class QApplication;

namespace mapwright::window {

enum class ThemeChoice { System, Light, Dark };

QString themeName(ThemeChoice choice);           // "system", "light", "dark": as in the settings
ThemeChoice themeFromName(const QString& name);  // anything else: System

/// What the desktop wanted before any theme was applied. Remembered in the application object, so it survives
/// palettes of our own.
bool systemIsDark(QApplication& app);

/// Sets Fusion, the palette and the style sheet. Returns whether it is dark now.
bool applyTheme(QApplication& app, ThemeChoice choice);

}  // namespace mapwright::window
