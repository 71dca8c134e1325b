#include "ui/window/appearance_controller.h"

#include <QActionGroup>
#include <QApplication>
#include <QEvent>
#include <QLayout>
#include <QWidget>

#include "ui/kit/actions.h"
#include "ui/scene/map_scene.h"
#include "ui/scene/map_theme.h"

namespace mapwright::ui {

namespace {

const QString kThemeKey = QStringLiteral("view/theme");

ThemeChoice chosenTheme(const QSettings& settings) {
  return themeFromName(settings.value(kThemeKey).toString());
}

void show(ThemeChoice choice, scene::MapScene& scene) {
  const bool dark = applyTheme(*qApp, choice);
  scene.setTheme(dark ? scene::darkMapTheme() : scene::lightMapTheme());
}

}  // namespace

void prepareChosenTheme(const QSettings& settings) { preparePalette(*qApp, chosenTheme(settings)); }

void showChosenTheme(QWidget& window, const QSettings& settings, scene::MapScene& scene) {
  show(chosenTheme(settings), scene);
  // Layouts in hidden docks would keep the sizes that their widgets had without the style sheet.
  for (QWidget* const widget : window.findChildren<QWidget*>()) widget->updateGeometry();
  for (QLayout* const layout : window.findChildren<QLayout*>()) layout->invalidate();
}

AppearanceController::AppearanceController(WindowContext& context, QObject* parent)
    : Controller(parent),
      context_(context),
      theme_(chosenTheme(context.settings)),
      themes_(new QActionGroup(this)) {
  const auto theme = [this](const char* id, const QString& text, ThemeChoice choice, int rank) {
    QAction* const action = context_.actions.add(
        {.id = id, .text = text, .tip = text, .toggle = true, .menu = {MenuGroup::Theme, rank}}, this,
        [this, choice] { setTheme(choice); });
    action->setData(int(choice));
    themes_->addAction(action);
    if (choice == theme_) action->setChecked(true);
  };
  theme("themeLight", tr("Light theme"), ThemeChoice::Light, 10);
  theme("themeDark", tr("Dark theme"), ThemeChoice::Dark, 20);
  theme("themeSystem", tr("Theme of the system"), ThemeChoice::System, 30);
  full_screen_ = context_.actions.add(
      {.id = "fullScreen",
       .text = tr("F&ull screen"),
       .icon = "expand",
       .keys = {"F11"},
       .tip = tr("Use the whole screen"),
       .toggle = true,
       .menu = {MenuGroup::Window, 30}},
      this, [this](bool on) {
        context_.window.setWindowState(context_.window.windowState().setFlag(Qt::WindowFullScreen, on));
      });
  context_.window.installEventFilter(this);
}

void AppearanceController::setTheme(ThemeChoice choice) {
  theme_ = choice;
  show(choice, context_.scene);
  for (QAction* action : themes_->actions()) {
    if (action->data().toInt() == int(choice)) action->setChecked(true);
  }
  context_.settings.setValue(kThemeKey, themeName(choice));
}

void AppearanceController::remember(QSettings& settings) { settings.setValue(kThemeKey, themeName(theme_)); }

bool AppearanceController::eventFilter(QObject* watched, QEvent* event) {
  // The desktop may also toggle full screen.
  if (event->type() == QEvent::WindowStateChange && watched == &context_.window)
    full_screen_->setChecked(context_.window.isFullScreen());
  return Controller::eventFilter(watched, event);
}

}  // namespace mapwright::ui

#include "moc_appearance_controller.cpp"
