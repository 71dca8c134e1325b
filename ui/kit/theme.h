// Light, dark or system theme: palette and style sheet of the whole application.
#pragma once

#include <QString>

class QApplication;

namespace mapwright::ui {

enum class ThemeChoice { System, Light, Dark };

QString themeName(ThemeChoice choice);           // "system", "light", "dark": as in the settings
ThemeChoice themeFromName(const QString& name);  // anything else: System

/// The desktop's preference before any theme was applied. Stored in the application object, so our own
/// palettes do not change it.
bool systemIsDark(QApplication& app);

/// Sets Fusion and the palette, and removes the style sheet: for a window that is being built. With a style
/// sheet Qt polishes a widget again, and all in it, each time it gets another parent. Returns whether it is
/// dark now.
bool preparePalette(QApplication& app, ThemeChoice choice);

/// Sets Fusion, the palette and the style sheet. Returns whether it is dark now.
bool applyTheme(QApplication& app, ThemeChoice choice);

}  // namespace mapwright::ui
