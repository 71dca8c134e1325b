#include "ui/kit/theme.h"

#include <QApplication>
#include <QPalette>
#include <QStyle>
#include <QStyleFactory>
#include <QVariant>

#include "ui/kit/icons.h"
#include "ui/kit/ui_colors.h"

namespace mapwright::ui {

namespace {

constexpr const char* kSystemDark = "mapwright_system_dark";

// Fusion draws the rest; this only gives spacing on the 4 px grid, flat tool buttons and a common look for
// docks and cards.
QString styleSheet(const UiColors& c) {
  QString css = QStringLiteral(R"(
QToolTip { color: %text%; background: %tooltip%; border: 1px solid %border%; padding: 4px 6px; }
QMainWindow::separator { background: %border%; margin: 2px; width: 1px; height: 1px; }
QMainWindow::separator:hover { background: %accent%; }
QMenuBar { background: %window%; padding: 0 4px; }
QMenuBar::item { padding: 4px 8px; border-radius: 4px; background: transparent; }
QMenuBar::item:selected { background: %hover%; }
QToolBar { background: %window%; border: none; border-bottom: 1px solid %border%; padding: 2px 8px; spacing: 2px; }
QToolBar::separator { background: %border%; width: 1px; margin: 6px 6px; }
QToolButton { border: 1px solid transparent; border-radius: 4px; padding: 3px; background: transparent; }
#allTabs { background: %window%; border: none; border-radius: 0; padding: 0; }
#allTabs:hover { background: %hover%; }
#qt_toolbar_ext_button { padding: 0; border: none; }
QToolButton:hover { background: %hover%; }
QToolButton:pressed { background: %border%; }
QToolButton:checked { background: %tint%; border-color: %focus%; }
QToolButton:focus { border: 2px solid %focus%; padding: 2px; }
QToolButton::menu-indicator { image: none; width: 0; }
QStatusBar { background: %window%; border-top: 1px solid %border%; }
QStatusBar::item { border: none; }
QHeaderView::section { background: %window%; color: %secondary%; border: none; border-bottom: 1px solid %border%;
  padding: 3px 6px; }
QHeaderView, QTableCornerButton::section { background: %window%; border: none; }
QTreeView, QTableView, QListView { border: 1px solid transparent; outline: 0; }
QTreeView:focus, QTableView:focus, QListView:focus { border-color: %focus%; }
QLineEdit { border: 1px solid %outline%; border-radius: 4px; padding: 2px 6px; background: %base%;
  min-height: 18px; selection-background-color: %accent%;
  selection-color: white; }
QLineEdit:focus { border-color: %focus%; }
QLineEdit:disabled { color: %disabled%; background: transparent; border-color: %border%; }
QComboBox, QSpinBox, QDoubleSpinBox { border: 1px solid %outline%; border-radius: 4px; padding: 2px 6px; background: %base%;
  min-height: 18px; }
QComboBox:focus, QSpinBox:focus, QDoubleSpinBox:focus { border-color: %focus%; }
QSpinBox[beyond="true"], QDoubleSpinBox[beyond="true"] { color: %error_text%; border-color: %error_text%; }
QComboBox:disabled, QSpinBox:disabled, QDoubleSpinBox:disabled { color: %disabled%; background: transparent; border-color: %border%; }
QComboBox::drop-down { border: none; width: 20px; }
QComboBox::down-arrow, QSpinBox::down-arrow, QDoubleSpinBox::down-arrow { image: url(:/controls/down.svg); width: 12px; height: 12px; }
QSpinBox::up-arrow, QDoubleSpinBox::up-arrow { image: url(:/controls/up.svg); width: 12px; height: 12px; }
QSpinBox::up-button, QSpinBox::down-button, QDoubleSpinBox::up-button, QDoubleSpinBox::down-button { border: none; width: 18px; background: transparent; }
QCheckBox, QRadioButton { spacing: 6px; }
QCheckBox:disabled, QRadioButton:disabled { color: %disabled%; }
QCheckBox::indicator, QRadioButton::indicator, QTreeView::indicator { width: 13px; height: 13px;
  border: 1px solid %outline%; border-radius: 3px; background: %base%; }
QCheckBox::indicator:checked, QTreeView::indicator:checked { background: %accent%; border-color: %focus%;
  image: url(:/controls/check.svg); }
QCheckBox::indicator:indeterminate, QTreeView::indicator:indeterminate { background: %accent%; border-color: %focus%;
  image: url(:/controls/partly.svg); }
QRadioButton::indicator { border-radius: 7px; }
QRadioButton::indicator:checked { background: %accent%; border-color: %focus%; image: url(:/controls/dot.svg); }
QCheckBox::indicator:focus, QRadioButton::indicator:focus { width: 11px; height: 11px; border: 2px solid %text%; }
QCheckBox::indicator:disabled, QRadioButton::indicator:disabled, QTreeView::indicator:disabled {
  background: transparent; border-color: %disabled%; }
QCheckBox::indicator:checked:disabled, QCheckBox::indicator:indeterminate:disabled, QTreeView::indicator:checked:disabled,
QTreeView::indicator:indeterminate:disabled { background: %disabled%; border-color: %disabled%; }
QRadioButton::indicator:checked:disabled { background: %disabled%; border-color: %disabled%; }
QMenu { background: %base%; border: 1px solid %border%; padding: 4px 0; }
QMenu::separator { height: 1px; background: %border%; margin: 4px 8px; }
QSplitter::handle { background: %border%; }
QScrollBar:vertical { background: transparent; width: 10px; margin: 0; }
QScrollBar:horizontal { background: transparent; height: 10px; margin: 0; }
QScrollBar::handle { background: %handle%; border-radius: 4px; margin: 1px; min-height: 24px; min-width: 24px; }
QScrollBar::handle:hover { background: %secondary%; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
QTabBar::tab { padding: 4px 12px; background: transparent; color: %secondary%; border: none;
  border-bottom: 2px solid transparent; }
QTabBar::tab:selected { color: %text%; border-bottom-color: %focus%; }
QTabBar::tab:hover { color: %text%; }
QTabBar::tab:focus { color: %text%; border: 2px solid %focus%; padding: 2px 10px 4px; border-radius: 3px; }
#card { background: %window%; border: 1px solid %border%; border-radius: 8px; }
#furniture { background: %furniture%; border: 1px solid %border%; border-radius: 6px; }
#compareBar { background: %window%; border: none; border-bottom: 1px solid %border%; }
#toast, #outOfRange { background: %window%; border: 1px solid %border%; border-radius: 6px; }
#primary { background: %accent%; color: white; border: 1px solid %accent%; border-radius: 4px; padding: 5px 14px; }
#primary:hover { background: #1a60cf; }
#primary:pressed { background: #1653b5; }
#primary:focus { border: 2px solid %text%; padding: 4px 13px; }
#primary:disabled { background: transparent; border-color: %border%; color: %disabled%; }
#secondary { background: transparent; color: %text%; border: 1px solid %outline%; border-radius: 4px; padding: 5px 14px; }
#secondary:hover { background: %hover%; }
#secondary:focus { border: 2px solid %focus%; padding: 4px 13px; }
#secondary:disabled { color: %disabled%; border-color: %border%; }
#details { border-top: 1px solid %border%; }
#recents::item:selected, #recents::item:hover { background: %hover%; color: %text%; }
#recents::item:selected { border-left: 3px solid %focus%; }
#compact { background: transparent; color: %text%; border: 1px solid %outline%; border-radius: 4px; padding: 2px 10px; }
#compact:hover { background: %hover%; }
#compact:focus { border: 2px solid %focus%; padding: 1px 9px; }
#compact:disabled { color: %disabled%; border-color: %border%; }
#compact:checked { background: %tint%; border-color: %focus%; }
#recents { background: %base%; border: 1px solid %border%; border-radius: 4px; }
#recents:focus { border-color: %focus%; }
)");
  const auto put = [&css](const char* key, const QColor& color) {
    css.replace(QLatin1String(key), color.alpha() == 255 ? color.name()
                                                         : QStringLiteral("rgba(%1,%2,%3,%4)")
                                                               .arg(color.red())
                                                               .arg(color.green())
                                                               .arg(color.blue())
                                                               .arg(color.alpha()));
  };
  QColor tint = c.accent;
  tint.setAlpha(c.dark ? 70 : 36);
  QColor furniture = c.window;
  furniture.setAlpha(225);
  put("%text%", c.text);
  put("%tooltip%", c.tooltip);
  put("%border%", c.border);
  put("%accent%", c.accent);
  put("%window%", c.window);
  put("%hover%", c.hover);
  put("%tint%", tint);
  put("%base%", c.base);
  put("%secondary%", c.secondary_text);
  put("%neutral%", c.neutral);
  put("%focus%", c.focus);
  put("%outline%", c.outline);
  put("%error_text%", c.error_text);
  put("%disabled%", c.disabled);
  put("%handle%", c.outline);
  put("%furniture%", furniture);
  return css;
}

}  // namespace

QString themeName(ThemeChoice choice) {
  switch (choice) {
    case ThemeChoice::Light:
      return QStringLiteral("light");
    case ThemeChoice::Dark:
      return QStringLiteral("dark");
    case ThemeChoice::System:
      break;
  }
  return QStringLiteral("system");
}

ThemeChoice themeFromName(const QString& name) {
  if (name == QLatin1String("light")) return ThemeChoice::Light;
  if (name == QLatin1String("dark")) return ThemeChoice::Dark;
  return ThemeChoice::System;
}

bool systemIsDark(QApplication& app) {
  QVariant known = app.property(kSystemDark);
  if (!known.isValid()) {
    known = app.palette().color(QPalette::Window).lightness() < 128;
    app.setProperty(kSystemDark, known);
  }
  return known.toBool();
}

bool preparePalette(QApplication& app, ThemeChoice choice) {
  loadResources();
  const bool system_dark = systemIsDark(app);
  const bool dark = choice == ThemeChoice::Dark || (choice == ThemeChoice::System && system_dark);
  const UiColors colors = uiColors(dark);
  // A style sheet wraps the style and hides its name, so the previous one is removed first.
  app.setStyleSheet(QString());
  if (app.style()->name() != QLatin1String("fusion"))
    app.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  const QPalette palette = themePalette(colors);
  app.setPalette(palette);
  for (const char* lists : {"QAbstractItemView", "QMenu"})
    app.setPalette(listPalette(palette, colors), lists);
  return dark;
}

bool applyTheme(QApplication& app, ThemeChoice choice) {
  const bool dark = preparePalette(app, choice);
  app.setStyleSheet(styleSheet(uiColors(dark)));
  return dark;
}

}  // namespace mapwright::ui
