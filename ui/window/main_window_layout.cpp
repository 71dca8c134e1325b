// MainWindow: docks, and what is remembered of the layout.
#include <utility>

#include <QActionGroup>
#include <QDir>
#include <QGuiApplication>
#include <QScreen>

#include "window/docks/dock_title.h"
#include "window/docks/inspector_dock.h"
#include "window/docks/layer_memory.h"
#include "window/docks/layers_dock.h"
#include "window/docks/maps_dock.h"
#include "window/docks/messages_dock.h"
#include "window/docks/problems_dock.h"
#include "window/docks/robot_dock.h"
#include "window/main_window.h"
#include "window/map/compare_control.h"
#include "window/map/map_overlay.h"
#include "window/map/map_view.h"
#include "window/map/toast_stack.h"

namespace mapwright::window {

namespace {

// Raised whenever docks or tool bars come or go, so that an old state is not forced upon a new layout.
constexpr int kLayoutVersion = 2;
constexpr int kLeftPx = 220;
constexpr int kRightPx = 322;
constexpr int kBottomPx = 168;
constexpr int kFramePx = 8, kTitleBarPx = 40;

QString colorModeName(render::ColorMode mode) {
  switch (mode) {
    case render::ColorMode::Incremental:
      return QStringLiteral("incremental");
    case render::ColorMode::Active:
      return QStringLiteral("active");
    case render::ColorMode::Normal:
      break;
  }
  return QStringLiteral("normal");
}

}  // namespace

void MainWindow::createDocks() {
  layers_ = new LayersDock(scene_.get(), this);
  inspector_ = new InspectorDock(scene_.get(), actions_.find(QStringLiteral("showIds")),
                                 actions_.find(QStringLiteral("showOutlines")), this);
  problems_ = new ProblemsDock(this);
  maps_ = new MapsDock(this);
  robot_panel_ = new RobotDock(this);
  messages_ = new MessagesDock({}, this);
  for (QDockWidget* dock : docks()) giveTitle(dock);
  setDockNestingEnabled(true);
  setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  placeDocks();
  connect(inspector_, &InspectorDock::locateWanted, this, &MainWindow::locate);
  connect(inspector_, &InspectorDock::colorModeWanted, this, &MainWindow::setColorMode);
  connect(inspector_, &InspectorDock::copyWanted, this, &MainWindow::copyText);
  connect(maps_, &MapsDock::openWanted, this, &MainWindow::openMap);
  connect(maps_, &MapsDock::copyWanted, this, &MainWindow::copyText);
  connect(maps_, &MapsDock::compareWanted, this, [this](const map::MapKey& key) { comparison_->start(key); });
  connect(maps_, &MapsDock::exportWanted, this, [this](const map::MapKey& key) {
    const session::MapSlot& slot = session_->wholeMap();
    if (slot.key() == key && slot.phase() == session::MapSlot::Phase::Ready) {
      exportMap();
      return;
    }
    export_when_read_ = key;
    openMap(key);
  });
  connect(messages_, &MessagesDock::copyWanted, this, &MainWindow::copyText);
  connect(problems_, &ProblemsDock::copyWanted, this, &MainWindow::copyText);
  connect(problems_, &ProblemsDock::retryWanted, actions_.find(QStringLiteral("retry")), &QAction::trigger);
}

void MainWindow::arrangeDocks() {
  placeDocks();
  front_tabs_chosen_ = false;
  // Which tab is in front is settled only when the window has been laid out.
  QTimer::singleShot(0, this, [this] {
    if (front_tabs_chosen_) return;
    const bool catalogue_first = mode_before_ && session_ && session_->catalogue().offered();
    (catalogue_first ? static_cast<QDockWidget*>(maps_) : layers_)->raise();
    inspector_->raise();
  });
}

void MainWindow::placeDocks() {
  for (QDockWidget* dock : docks()) {
    dock->setFloating(false);
    removeDockWidget(dock);
  }
  const auto stack = [this](Qt::DockWidgetArea area, QDockWidget* first, QDockWidget* second) {
    addDockWidget(area, first);
    addDockWidget(area, second);
    tabifyDockWidget(first, second);
  };
  stack(Qt::LeftDockWidgetArea, maps_, layers_);
  stack(Qt::RightDockWidgetArea, robot_panel_, inspector_);
  stack(Qt::BottomDockWidgetArea, messages_, problems_);
  for (QDockWidget* dock : {static_cast<QDockWidget*>(maps_), static_cast<QDockWidget*>(layers_),
                            static_cast<QDockWidget*>(robot_panel_), static_cast<QDockWidget*>(inspector_)})
    dock->show();
  problems_->hide();
  messages_->hide();
  resizeDocks({layers_, inspector_}, {kLeftPx, kRightPx}, Qt::Horizontal);
  resizeDocks({problems_}, {kBottomPx}, Qt::Vertical);
}

void MainWindow::resetLayout() {
  arrangeDocks();
  resetOrderAndStyles(*scene_);
  resetVisibility(*scene_);
  if (mode_before_) setMapMode(ViewMode::Whole);
  setColorMode(render::ColorMode::Normal);
  actions_.find(QStringLiteral("furniture"))->setChecked(true);
  setMeasuring(false);
}

void MainWindow::restoreSettings() {
  const QSettings& settings = dependencies_.settings;
  if (!restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray())) {
    const QRect room = QGuiApplication::primaryScreen()->availableGeometry();
    // Room for the frame that the window manager puts around it.
    resize(qMin(1600, room.width() - kFramePx), qMin(1000, room.height() - kTitleBarPx));
  }
  if (restoreState(settings.value(QStringLiteral("window/state")).toByteArray(), kLayoutVersion)) {
    front_tabs_chosen_ = true;
    problems_shown_once_ = settings.value(QStringLiteral("window/problemsShown"), false).toBool();
  } else {
    arrangeDocks();
  }
  restoreLayers(*scene_, settings);
  const QString colors = settings.value(QStringLiteral("view/colors")).toString();
  for (const auto mode :
       {render::ColorMode::Normal, render::ColorMode::Incremental, render::ColorMode::Active}) {
    if (colors == colorModeName(mode) || mode == render::ColorMode::Normal) setColorMode(mode);
  }
  actions_.find(QStringLiteral("furniture"))
      ->setChecked(settings.value(QStringLiteral("view/furniture"), true).toBool());
  setMeasuring(settings.value(QStringLiteral("view/tool")).toString() == QLatin1String("measure"));
  for (QAction* action : theme_actions_->actions()) {
    if (action->data().toInt() == int(theme_)) action->setChecked(true);
  }
  syncLayerActions();
}

void MainWindow::saveSettings() {
  QSettings& settings = dependencies_.settings;
  settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
  settings.setValue(QStringLiteral("window/state"), saveState(kLayoutVersion));
  settings.setValue(QStringLiteral("window/problemsShown"), problems_shown_once_);
  settings.setValue(QStringLiteral("view/theme"), themeName(theme_));
  settings.setValue(QStringLiteral("view/colors"), colorModeName(scene_->colorMode()));
  settings.setValue(QStringLiteral("view/furniture"), overlay_->furnitureVisible());
  settings.setValue(QStringLiteral("view/tool"), view_->tool()->name());
  // A robot that has no submaps must not decide what the next one shows.
  const std::optional<ViewMode> before = mode_before_;
  if (before) endMapMode();
  saveLayers(*scene_, settings);
  if (before && session_) beginMapMode();
}

void MainWindow::noteSettings() {
  QSettings& settings = dependencies_.settings;
  settings.sync();
  if (settings.status() == QSettings::NoError || std::exchange(settings_told_, true)) return;
  overlay_->toasts()->add(
      Mark::Warning,
      tr("The layout and the recent robots cannot be kept: %1 cannot be written. Is the disk full?")
          .arg(QDir::toNativeSeparators(settings.fileName())));
}

void MainWindow::setColorMode(render::ColorMode mode) {
  scene_->setColorMode(mode);
  inspector_->setColorMode(mode);
  for (QAction* action : color_actions_->actions()) {
    if (action->data().toInt() == int(mode)) action->setChecked(true);
  }
}

void MainWindow::syncLayerActions() {
  const auto sync = [this](const char* id, scene::Layer layer) {
    actions_.find(QLatin1String(id))->setChecked(scene_->layerVisible(layer));
  };
  sync("grid", scene::Layer::Grid);
  sync("showIds", scene::Layer::Ids);
  sync("showOutlines", scene::Layer::Outlines);
  syncModeActions();
  refreshState();
  fitNewMap();
}

}  // namespace mapwright::window
