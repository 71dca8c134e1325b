// MainWindow: actions, menus and the tool bar.
#include <QActionGroup>
#include <QApplication>
#include <QClipboard>
#include <QFileInfo>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

#include "geometry/pose.h"
#include "window/dialogs/command_palette.h"
#include "window/dialogs/shortcut_sheet.h"
#include "window/docks/inspector_controls.h"
#include "window/docks/inspector_dock.h"
#include "window/docks/layers_dock.h"
#include "window/docks/maps_dock.h"
#include "window/docks/messages_dock.h"
#include "window/docks/problems_dock.h"
#include "window/docks/robot_dock.h"
#include "window/files/map_files.h"
#include "window/look/icons.h"
#include "window/look/plain_label.h"
#include "window/main_window.h"
#include "window/map/map_overlay.h"
#include "window/map/map_view.h"
#include "window/map/measure_tool.h"
#include "window/map/toast_stack.h"
#include "window/status/connection_chip.h"
#include "words/qt_plain.h"

namespace mapwright::window {

namespace {

const QString kRobot = QStringLiteral("Robot");
const QString kMap = QStringLiteral("Map");
const QString kView = QStringLiteral("View");
const QString kHelp = QStringLiteral("Help");
constexpr double kTurn = geometry::radiansFromDegrees(15);

QKeySequence key(const char* text) { return QKeySequence(QLatin1String(text)); }

}  // namespace

void MainWindow::createActions() {
  createRobotActions();
  createFileActions();
  createMapActions();
  createCompareActions();
  createModeActions();
  createViewActions();
  createHelpActions();
}

void MainWindow::createRobotActions() {
  const auto on = [this](QAction* action, auto&& what) { connect(action, &QAction::triggered, this, what); };
  on(actions_.add(kRobot, QStringLiteral("connect"), QStringLiteral("&Connect…"), QStringLiteral("connect"),
                  {key("Ctrl+O")}, Reach::Everywhere, QStringLiteral("Connect to a robot")),
     [this] { openConnectDialog(); });
  on(actions_.add(kRobot, QStringLiteral("demo"), QStringLiteral("Try the &demo robot"),
                  QStringLiteral("demo"), {}, Reach::Everywhere,
                  QStringLiteral("Connect to a simulated robot inside this program")),
     [this] {
       if (const auto error = connectTo(QStringLiteral("demo:"))) overlay_->toasts()->add(Mark::Bad, *error);
     });
  on(actions_.add(kRobot, QStringLiteral("retry"), QStringLiteral("&Retry now"), QStringLiteral("retry"),
                  {key("F5")}, Reach::Everywhere,
                  QStringLiteral("Reconnect, and ask again for everything that failed")),
     [this] { retry(); });
  on(actions_.add(kRobot, QStringLiteral("disconnect"), QStringLiteral("D&isconnect"),
                  QStringLiteral("disconnect"), {}, Reach::Everywhere, QStringLiteral("Leave this robot")),
     [this] { leaveRobot(); });
  on(actions_.add(kRobot, QStringLiteral("quit"), QStringLiteral("&Quit"), {}, {key("Ctrl+Q")},
                  Reach::Everywhere, QStringLiteral("Quit mapwright")),
     [this] { close(); });
}

void MainWindow::createMapActions() {
  const auto on = [this](QAction* action, auto&& what) { connect(action, &QAction::triggered, this, what); };
  on(actions_.add(kMap, QStringLiteral("zoomIn"), QStringLiteral("Zoom &in"), QStringLiteral("zoom-in"),
                  {key("+"), key("=")}, Reach::OutsideText, QStringLiteral("Zoom in")),
     [this] { view_->zoomSteps(1); });
  on(actions_.add(kMap, QStringLiteral("zoomOut"), QStringLiteral("Zoom &out"), QStringLiteral("zoom-out"),
                  {key("-")}, Reach::OutsideText, QStringLiteral("Zoom out")),
     [this] { view_->zoomSteps(-1); });
  on(actions_.add(kMap, QStringLiteral("native"), QStringLiteral("&1:1"), QStringLiteral("native"),
                  {key("0")}, Reach::OutsideText, QStringLiteral("One cell of 5 cm on one pixel")),
     [this] { view_->setScale(kNativeScaleMPerPx); });
  on(actions_.add(kMap, QStringLiteral("fit"), QStringLiteral("&Fit"), QStringLiteral("fit"), {key("F")},
                  Reach::OutsideText, QStringLiteral("Show the whole map")),
     [this] { fit(); });
  on(actions_.addToggle(kMap, QStringLiteral("follow"), QStringLiteral("Follow the &robot"),
                        QStringLiteral("follow"), {key("R")}, Reach::OutsideText,
                        QStringLiteral("Keep the robot in the middle; panning ends it")),
     [this](bool follow) {
       view_->setFollowing(follow);
       if (follow && scene_->robotPlace().drawn == scene::ScreenPart::None) {
         overlay_->toasts()->add(
             Mark::Warning,
             tr("The robot is not in this map. It is followed again in the map that it is in."));
         return;
       }
       if (follow && session_ && !session_->live().robot_pose) {
         overlay_->toasts()->add(
             Mark::Neutral,
             QStringLiteral("The robot has not told its position yet. It will be followed then."));
       }
     });
  on(actions_.add(kMap, QStringLiteral("northUp"), QStringLiteral("&North up"), QStringLiteral("north"),
                  {key("N")}, Reach::OutsideText,
                  QStringLiteral("Turn the view so that the map's y axis points up")),
     [this] { view_->setRotation(0); });
  on(actions_.add(kMap, QStringLiteral("robotTurn"), QStringLiteral("Turn as the robot shows i&t"),
                  QStringLiteral("north"), {}, Reach::OutsideText,
                  QStringLiteral("Turn the view as this map's robot shows it to people")),
     [this] {
       if (const auto rad = session_ ? session_->wholeMap().shown().display_rotation_rad : std::nullopt)
         view_->setRotation(*rad);
     });
  on(actions_.add(kMap, QStringLiteral("rotateLeft"), QStringLiteral("Turn &left"),
                  QStringLiteral("rotate-left"), {key("[")}, Reach::OutsideText,
                  QStringLiteral("Turn the view by 15° counter-clockwise")),
     [this] { view_->rotateBy(kTurn); });
  on(actions_.add(kMap, QStringLiteral("rotateRight"), QStringLiteral("Turn r&ight"),
                  QStringLiteral("rotate-right"), {key("]")}, Reach::OutsideText,
                  QStringLiteral("Turn the view by 15° clockwise")),
     [this] { view_->rotateBy(-kTurn); });
  on(actions_.add(kMap, QStringLiteral("goTo"), QStringLiteral("&Go to coordinates…"), QStringLiteral("goto"),
                  {key("Ctrl+G")}, Reach::Everywhere, QStringLiteral("Centre the map on a point")),
     [this] { goTo(); });
  QAction* pan =
      actions_.addToggle(kMap, QStringLiteral("pan"), QStringLiteral("&Pan"), QStringLiteral("pan"),
                         {key("P")}, Reach::OutsideText, QStringLiteral("Drag the map"));
  on(pan, [this] { setMeasuring(false); });
  on(actions_.addToggle(kMap, QStringLiteral("measure"), QStringLiteral("&Measure"),
                        QStringLiteral("measure"), {key("M")}, Reach::OutsideText,
                        QStringLiteral("Measure distances along clicked points")),
     [this](bool checked) { setMeasuring(checked); });
  on(actions_.add(kMap, QStringLiteral("copyCoordinates"), QStringLiteral("Copy &coordinates"),
                  QStringLiteral("copy"), {key("C")}, Reach::OutsideText,
                  QStringLiteral("Copy the world coordinates under the cursor")),
     [this] { copyCoordinates(view_->cursorWorld().value_or(scene_->view().center_m)); });
  on(actions_.add(kMap, QStringLiteral("screenshotCopy"), QStringLiteral("Copy pict&ure"),
                  QStringLiteral("copy"), {key("Ctrl+Shift+C")}, Reach::Everywhere,
                  QStringLiteral("Copy the map as a picture")),
     [this] {
       QGuiApplication::clipboard()->setImage(mapPicture());
       overlay_->toasts()->add(Mark::Good, QStringLiteral("Picture copied"));
     });
  on(actions_.add(kMap, QStringLiteral("screenshotSave"), QStringLiteral("&Save picture…"),
                  QStringLiteral("screenshot"), {key("Ctrl+Shift+S")}, Reach::Everywhere,
                  QStringLiteral("Save the map as a PNG picture")),
     [this] { askAndSavePicture(); });
}

void MainWindow::createViewActions() {
  const auto layer = [this](const char* id, const QString& text, const char* icon_name,
                            const QList<QKeySequence>& keys, scene::Layer which, const QString& tip) {
    QAction* action = actions_.addToggle(kView, QLatin1String(id), text, QLatin1String(icon_name), keys,
                                         Reach::OutsideText, tip);
    connect(action, &QAction::triggered, this,
            [this, which](bool on) { scene_->setLayerVisible(which, on); });
  };
  layer("grid", QStringLiteral("&Grid"), "grid", {key("G")}, scene::Layer::Grid,
        QStringLiteral("Show the metric grid"));
  layer("showIds", QStringLiteral("Submap &ids"), "ids", {key("I")}, scene::Layer::Ids,
        QStringLiteral("Show the ids of the submaps on the map"));
  layer("showOutlines", QStringLiteral("Submap &outlines"), "outlines", {key("O")}, scene::Layer::Outlines,
        QStringLiteral("Show the outlines of the submaps on the map"));
  QAction* furniture = actions_.addToggle(
      kView, QStringLiteral("furniture"), QStringLiteral("&Buttons on the map"), QStringLiteral("furniture"),
      {key("Tab")}, Reach::Map, QStringLiteral("Show the buttons that float over the map"));
  furniture->setChecked(true);
  connect(furniture, &QAction::toggled, this, [this](bool on) { overlay_->setFurnitureVisible(on); });

  color_actions_ = new QActionGroup(this);
  const auto colors = [this](const char* id, const QString& text, render::ColorMode mode,
                             const QString& tip) {
    QAction* action = actions_.addToggle(kView, QLatin1String(id), text, {}, {}, Reach::Everywhere, tip);
    action->setData(int(mode));
    color_actions_->addAction(action);
    connect(action, &QAction::triggered, this, [this, mode] { setColorMode(mode); });
  };
  colors("colorsNormal", QStringLiteral("Normal colours"), render::ColorMode::Normal,
         QStringLiteral("Grey as usual"));
  colors("colorsIncremental", QStringLiteral("Incremental submaps tinted"), render::ColorMode::Incremental,
         QStringLiteral("Incremental submaps in blue and red"));
  colors("colorsActive", QStringLiteral("Frozen submaps dimmed"), render::ColorMode::Active,
         QStringLiteral("Only active submaps at full strength"));

  theme_actions_ = new QActionGroup(this);
  const auto theme = [this](const char* id, const QString& text, ThemeChoice choice) {
    QAction* action = actions_.addToggle(kView, QLatin1String(id), text, {}, {}, Reach::Everywhere, text);
    action->setData(int(choice));
    theme_actions_->addAction(action);
    connect(action, &QAction::triggered, this, [this, choice] { setTheme(choice); });
  };
  theme("themeLight", QStringLiteral("Light theme"), ThemeChoice::Light);
  theme("themeDark", QStringLiteral("Dark theme"), ThemeChoice::Dark);
  theme("themeSystem", QStringLiteral("Theme of the system"), ThemeChoice::System);

  connect(actions_.add(kView, QStringLiteral("filter"), QStringLiteral("Filter &submaps"),
                       QStringLiteral("filter"), {key("Ctrl+F")}, Reach::Everywhere,
                       QStringLiteral("Go to the filter of the SLAM inspector")),
          &QAction::triggered, this, [this] {
            inspector_->show();
            inspector_->raise();
            inspector_->controls()->filterEdit()->setFocus();
            inspector_->controls()->filterEdit()->selectAll();
          });
  connect(actions_.add(kView, QStringLiteral("focusMap"), QStringLiteral("Go to the &map"), {}, {key("F6")},
                       Reach::Everywhere, QStringLiteral("Give the keyboard to the map")),
          &QAction::triggered, this, [this] { view_->setFocus(); });
  connect(actions_.addToggle(kView, QStringLiteral("fullScreen"), QStringLiteral("F&ull screen"),
                             QStringLiteral("expand"), {key("F11")}, Reach::Everywhere,
                             QStringLiteral("Use the whole screen")),
          &QAction::triggered, this,
          [this](bool on) { setWindowState(windowState().setFlag(Qt::WindowFullScreen, on)); });
  connect(actions_.add(kView, QStringLiteral("resetLayout"), QStringLiteral("&Reset layout"),
                       QStringLiteral("reset"), {}, Reach::Everywhere,
                       QStringLiteral("Docks, layers and colours as they were at first")),
          &QAction::triggered, this, [this] { resetLayout(); });
}

void MainWindow::createHelpActions() {
  connect(
      actions_.add(kHelp, QStringLiteral("palette"), QStringLiteral("&Commands…"), QStringLiteral("palette"),
                   {key("Ctrl+K")}, Reach::Everywhere, QStringLiteral("Find any command by its name")),
      &QAction::triggered, this, [this] {
        auto* palette = new CommandPalette(actions_, this);
        palette->setAttribute(Qt::WA_DeleteOnClose);
        palette->open();
      });
  connect(actions_.add(kHelp, QStringLiteral("shortcuts"), QStringLiteral("&Keys and gestures"),
                       QStringLiteral("keyboard"), {key("?"), key("F1")}, Reach::OutsideText,
                       QStringLiteral("All keys on one page")),
          &QAction::triggered, this, [this] { makeShortcutSheet(actions_, this)->open(); });
  connect(actions_.add(kHelp, QStringLiteral("about"), QStringLiteral("&About mapwright"),
                       QStringLiteral("info"), {}, Reach::Everywhere, QStringLiteral("Version and licences")),
          &QAction::triggered, this, [this] { makeAboutBox(this)->open(); });
}

void MainWindow::createMenus() {
  const auto menu = [this](const QString& title, std::initializer_list<const char*> ids) {
    QMenu* made = menuBar()->addMenu(title);
    made->setToolTipsVisible(true);
    for (const char* id : ids) {
      if (*id == '-') {
        made->addSeparator();
      } else {
        made->addAction(actions_.find(QLatin1String(id)));
      }
    }
    return made;
  };
  QMenu* robot = menu(QStringLiteral("&Robot"), {"connect", "openFile"});
  QMenu* files = robot->addMenu(QStringLiteral("Recent &files"));
  files->setToolTipsVisible(true);
  connect(files, &QMenu::aboutToShow, this, [this, files] {
    files->clear();
    addRecents(files, true, {});
    if (files->isEmpty()) files->addAction(QStringLiteral("None yet"))->setEnabled(false);
  });
  for (const char* id : {"demo", "-", "retry", "disconnect", "-", "quit"}) {
    *id == '-' ? (void)robot->addSeparator() : robot->addAction(actions_.find(QLatin1String(id)));
  }
  menu(QStringLiteral("&Map"), {"zoomIn",
                                "zoomOut",
                                "native",
                                "fit",
                                "-",
                                "follow",
                                "goTo",
                                "-",
                                "northUp",
                                "robotTurn",
                                "rotateLeft",
                                "rotateRight",
                                "-",
                                "pan",
                                "measure",
                                "-",
                                "compare",
                                "export",
                                "-",
                                "copyCoordinates",
                                "screenshotCopy",
                                "screenshotSave"});
  QMenu* view =
      menu(QStringLiteral("&View"), {"modeSubmaps", "modeWhole", "modeBoth", "-", "grid", "showIds",
                                     "showOutlines", "furniture", "-", "colorsNormal", "colorsIncremental",
                                     "colorsActive", "-", "themeLight", "themeDark", "themeSystem", "-"});
  for (QDockWidget* dock : docks()) {
    view->addAction(dock->toggleViewAction());
    actions_.list(kView, dock->toggleViewAction());
    // Whoever opens a panel wants to see it, not the tab in front of it; Qt puts it there only once it is
    // laid out.
    connect(dock->toggleViewAction(), &QAction::triggered, dock, [dock](bool on) {
      if (on) QMetaObject::invokeMethod(dock, &QDockWidget::raise, Qt::QueuedConnection);
    });
  }
  view->addSeparator();
  for (const char* id : {"filter", "focusMap", "fullScreen", "resetLayout"}) {
    view->addAction(actions_.find(QLatin1String(id)));
  }
  menu(QStringLiteral("&Help"), {"palette", "shortcuts", "-", "about"});
}

void MainWindow::createToolBar() {
  auto* bar = new QToolBar(QStringLiteral("Tools"), this);
  bar->setObjectName(QStringLiteral("tools"));
  bar->setMovable(false);
  bar->setFloatable(false);
  bar->setIconSize({20, 20});
  bar->toggleViewAction()->setVisible(false);
  addToolBar(Qt::TopToolBarArea, bar);
  chip_ = new ConnectionChip(bar);
  auto* robots = new QMenu(chip_);
  connect(robots, &QMenu::aboutToShow, this, [this, robots] { fillRobotMenu(robots); });
  chip_->setMenu(robots);
  bar->addWidget(chip_);
  for (const char* id :
       {"-",    "modeSubmaps",   "modeWhole", "modeBoth", "compare", "-",    "pan",     "measure",      "-",
        "fit",  "native",        "follow",    "northUp",  "-",       "grid", "showIds", "showOutlines", "-",
        "goTo", "screenshotSave"}) {
    if (*id == '-') {
      bar->addSeparator();
    } else {
      bar->addAction(actions_.find(QLatin1String(id)));
    }
  }
  auto* gap = new QWidget(bar);
  gap->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(gap);
  bar->addAction(actions_.find(QStringLiteral("palette")));
}

void MainWindow::fillRobotMenu(QMenu* menu) {
  menu->clear();
  menu->setToolTipsVisible(true);
  menu->addAction(actions_.find(QStringLiteral("connect")));
  menu->addAction(actions_.find(QStringLiteral("openFile")));
  menu->addAction(actions_.find(QStringLiteral("demo")));
  addRecents(menu, false, QStringLiteral("Recent robots"));
  addRecents(menu, true, QStringLiteral("Recent files"));
  if (session_) {
    menu->addSeparator();
    menu->addAction(actions_.find(QStringLiteral("retry")));
    menu->addAction(actions_.find(QStringLiteral("disconnect")));
  }
}

void MainWindow::addRecents(QMenu* menu, bool files, const QString& title) {
  bool first = true;
  for (const RecentRobot& robot : recents_.list()) {
    const QString path = pathOfAddress(robot.address);
    if (robot.address == address_ || path.isEmpty() == files) continue;
    if (first && !title.isEmpty()) menu->addSection(title);
    first = false;
    QString label =
        files ? QStringLiteral("%1  %2").arg(QFileInfo(path).fileName(), QFileInfo(path).absolutePath())
        : robot.name.isEmpty() ? robot.address
                               : QStringLiteral("%1  %2").arg(words::plainName(robot.name), robot.address);
    label.replace(QLatin1Char('&'), QLatin1String("&&"));  // no mnemonics from robots
    QAction* action = menu->addAction(label.left(120));
    action->setToolTip(plainToolTip(robot.address));
    connect(action, &QAction::triggered, this, [this, address = robot.address] { goToAddress(address); });
  }
}

std::vector<QDockWidget*> MainWindow::docks() const {
  return {maps_, layers_, inspector_, robot_panel_, problems_, messages_};
}

QMenu* MainWindow::createPopupMenu() {
  // The default one lists tool bars by names nobody knows.
  auto* menu = new QMenu(this);
  for (QDockWidget* dock : docks()) menu->addAction(dock->toggleViewAction());
  return menu;
}

}  // namespace mapwright::window
