// MainWindow: docks, and what is remembered of the layout.
#include <QActionGroup>
#include <QGuiApplication>
#include <QScreen>

#include "window/docks/dock_title.h"
#include "window/docks/inspector_dock.h"
#include "window/docks/layers_dock.h"
#include "window/docks/problems_dock.h"
#include "window/main_window.h"
#include "window/map/map_overlay.h"
#include "window/map/map_view.h"

namespace mapwright::window {

namespace {

// Raised whenever docks or tool bars come or go, so that an old state is not forced upon a new layout.
constexpr int kLayoutVersion = 1;
constexpr int kLeftPx = 200;
constexpr int kRightPx = 332;
constexpr int kBottomPx = 168;

QString visibleKey(scene::Layer layer) {
  return QStringLiteral("layers/%1/visible").arg(scene::layerName(layer));
}
QString opacityKey(scene::Layer layer) {
  return QStringLiteral("layers/%1/opacity").arg(scene::layerName(layer));
}

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
  for (QDockWidget* dock : {static_cast<QDockWidget*>(layers_), static_cast<QDockWidget*>(inspector_),
                            static_cast<QDockWidget*>(problems_)}) {
    giveTitle(dock);
  }
  setDockNestingEnabled(true);
  setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  arrangeDocks();
  connect(inspector_, &InspectorDock::locateWanted, this, &MainWindow::locate);
  connect(inspector_, &InspectorDock::colorModeWanted, this, &MainWindow::setColorMode);
  connect(inspector_, &InspectorDock::copyWanted, this, &MainWindow::copyText);
  connect(problems_, &ProblemsDock::copyWanted, this, &MainWindow::copyText);
  connect(problems_, &ProblemsDock::retryWanted, actions_.find(QStringLiteral("retry")), &QAction::trigger);
}

void MainWindow::arrangeDocks() {
  for (QDockWidget* dock : {static_cast<QDockWidget*>(layers_), static_cast<QDockWidget*>(inspector_),
                            static_cast<QDockWidget*>(problems_)}) {
    dock->setFloating(false);
  }
  addDockWidget(Qt::LeftDockWidgetArea, layers_);
  addDockWidget(Qt::RightDockWidgetArea, inspector_);
  addDockWidget(Qt::BottomDockWidgetArea, problems_);
  layers_->show();
  inspector_->show();
  problems_->hide();
  resizeDocks({layers_, inspector_}, {kLeftPx, kRightPx}, Qt::Horizontal);
  resizeDocks({problems_}, {kBottomPx}, Qt::Vertical);
}

void MainWindow::resetLayout() {
  arrangeDocks();
  for (const scene::Layer layer : scene::allLayers()) {
    const bool extra = layer == scene::Layer::Outlines || layer == scene::Layer::Ids;
    scene_->setLayerVisible(layer, !extra);
    scene_->setLayerOpacity(layer, 1.0);
  }
  setColorMode(render::ColorMode::Normal);
  actions_.find(QStringLiteral("furniture"))->setChecked(true);
  setMeasuring(false);
}

void MainWindow::restoreSettings() {
  const QSettings& settings = dependencies_.settings;
  if (!restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray())) {
    const QRect room = QGuiApplication::primaryScreen()->availableGeometry();
    resize(qMin(1600, room.width()), qMin(1000, room.height()));
  }
  if (restoreState(settings.value(QStringLiteral("window/state")).toByteArray(), kLayoutVersion)) {
    problems_->hide();  // it opens when there is something in it
  } else {
    arrangeDocks();
  }
  for (const scene::Layer layer : scene::allLayers()) {
    const bool extra = layer == scene::Layer::Outlines || layer == scene::Layer::Ids;
    scene_->setLayerVisible(layer, settings.value(visibleKey(layer), !extra).toBool());
    scene_->setLayerOpacity(layer, qBound(0.0, settings.value(opacityKey(layer), 1.0).toDouble(), 1.0));
  }
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
  settings.setValue(QStringLiteral("view/theme"), themeName(theme_));
  settings.setValue(QStringLiteral("view/colors"), colorModeName(scene_->colorMode()));
  settings.setValue(QStringLiteral("view/furniture"), overlay_->furnitureVisible());
  settings.setValue(QStringLiteral("view/tool"), view_->tool()->name());
  for (const scene::Layer layer : scene::allLayers()) {
    settings.setValue(visibleKey(layer), scene_->layerVisible(layer));
    settings.setValue(opacityKey(layer), scene_->layerOpacity(layer));
  }
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
}

}  // namespace mapwright::window
