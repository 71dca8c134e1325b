// Light or dark theme, and full screen.
#pragma once

#include "ui/kit/controller.h"
#include "ui/kit/theme.h"
#include "ui/shell/window_context.h"

class QActionGroup;

namespace mapwright::ui {

/// The saved theme without its style sheet, before any widget is made.
void prepareChosenTheme(const QSettings& settings);
/// Applies the saved theme to the program and the map, once all widgets of the window are made.
void showChosenTheme(QWidget& window, const QSettings& settings, scene::MapScene& scene);

class AppearanceController : public Controller {
  Q_OBJECT
 public:
  explicit AppearanceController(WindowContext& context, QObject* parent = nullptr);

  ThemeChoice theme() const { return theme_; }
  void setTheme(ThemeChoice choice);
  void remember(QSettings& settings) override;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  WindowContext& context_;
  ThemeChoice theme_;
  QActionGroup* themes_;
  QAction* full_screen_;
};

}  // namespace mapwright::ui
