// MainWindow: what can be done with the map.
#include <cmath>

#include <QApplication>
#include <QClipboard>
#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QPainter>
#include <QStandardPaths>

#include "scene/write_picture.h"
#include "window/dialogs/go_to_dialog.h"
#include "window/docks/inspector_dock.h"
#include "window/files/export_map.h"
#include "window/files/folders.h"
#include "window/look/icons.h"
#include "window/main_window.h"
#include "window/map/compare_control.h"
#include "window/map/map_furniture.h"
#include "window/map/map_overlay.h"
#include "window/map/map_view.h"
#include "window/map/measure_tool.h"
#include "window/map/toast_stack.h"
#include "window/status/window_status_bar.h"
#include "words/qt_plain.h"

namespace mapwright::window {

namespace {

constexpr int kCursorMs =
    40;  // what is under a resting cursor changes with the map: looked at again this often
constexpr double kLocateScaleMPerPx = 0.05;

}  // namespace

void MainWindow::wireMap() {
  cursor_timer_.setSingleShot(true);
  cursor_timer_.setInterval(kCursorMs);
  connect(&cursor_timer_, &QTimer::timeout, this, &MainWindow::showCursor);
  connect(view_, &MapView::cursorMoved, this, &MainWindow::showCursor);
  connect(&scene_->renderer(), &render::TileRenderer::tilesChanged, &cursor_timer_, [this] {
    if (!cursor_timer_.isActive()) cursor_timer_.start();
  });
  const auto camera_moved = [this] {
    bar_->showView(scene_->view());
    overlay_->furniture()->setRotation(scene_->view().rotation_rad);
  };
  connect(scene_.get(), &scene::MapScene::viewChanged, this, camera_moved);
  connect(scene_.get(), &scene::MapScene::layersChanged, this, &MainWindow::syncLayerActions);
  camera_moved();
  connect(view_, &MapView::movedByHand, this, [this] { may_fit_ = false; });
  connect(view_, &MapView::menuRequested, this, &MainWindow::showMapMenu);
  connect(scene_.get(), &scene::MapScene::contentChanged, this, &MainWindow::fitNewMap);
  connect(view_, &MapView::escaped, this, &MainWindow::escape);
  connect(static_cast<PanTool*>(pan_), &PanTool::clickedAt, this, [this](const Eigen::Vector2d& world) {
    if (!scene_->highlightedAt(world)) inspector_->clearSelection();
  });
  connect(inspector_, &InspectorDock::counted, bar_, &WindowStatusBar::recount);
  connect(view_, &MapView::followingChanged, actions_.find(QStringLiteral("follow")), &QAction::setChecked);
  connect(measure_, &MapTool::hintChanged, this,
          [this] { overlay_->setHint(view_->tool() == measure_ ? measure_->hint() : QString()); });
  connect(measure_, &MapTool::finished, this, [this] { setMeasuring(false); });
}

void MainWindow::escape() { comparison_->active() ? comparison_->end() : inspector_->clearSelection(); }

void MainWindow::keyPressEvent(QKeyEvent* event) {
  // What no widget below wanted: Esc means the same wherever the focus is.
  if (event->key() != Qt::Key_Escape) return QMainWindow::keyPressEvent(event);
  auto* search = qobject_cast<QLineEdit*>(focusWidget());
  if (search && search->isClearButtonEnabled() && !search->text().isEmpty()) {
    search->clear();
  } else {
    view_->setFollowing(false);
    escape();
  }
  event->accept();
}

void MainWindow::showCursor() {
  const auto world = view_->cursorWorld();
  if (!world) {
    bar_->showCursor({}, {});
    return;
  }
  bar_->showCursor(coordinatesText(*world, scene_->view().scale_m_per_px),
                   session_ ? occupancyText(scene_->occupancyAt(*world)) : QString());
}

void MainWindow::fit() {
  if (session_) view_->fit(scene_->contentBounds(), true);
}

void MainWindow::fitAtFirst() {
  if (!may_fit_ || !session_ || !scene_->layerVisible(scene::Layer::Submaps)) return;
  const session::SubmapCounts counts = session_->counts();
  const geometry::WorldRect bounds = session_->contentBounds();
  if (counts.listed == 0 || bounds.empty()) return;
  if (!fitted_poses_) {
    // Only the poses are known yet: leave room for what lies around them.
    fitted_poses_ = true;
    view_->fit(counts.shown > 0 ? bounds : bounds.grown(8.0), false, 0.01);
  }
  if (counts.pending == 0 && counts.shown > 0) {
    may_fit_ = false;
    view_->fit(bounds, false, 0.01);
  }
}

void MainWindow::locate(map::SubmapId id) {
  if (!session_) return;
  const geometry::WorldRect bounds = session_->book().bounds(id, session_->slice());
  if (bounds.empty()) {
    overlay_->toasts()->add(Mark::Warning, QStringLiteral("Submap %1 has no usable pose, so it lies nowhere.")
                                               .arg(QString::fromStdString(map::toText(id))));
    return;
  }
  geometry::ViewTransform to = view_->destination();
  to.center_m = bounds.center();
  const double smaller_px = std::min(to.width_px, to.height_px);
  const double extent = std::max(bounds.width(), bounds.height());
  // Nearer when it would be a speck, farther when it would not fit; else the scale is the user's.
  if (extent / to.scale_m_per_px > smaller_px) {
    to = to.fitted(bounds, 48);
  } else if (extent / to.scale_m_per_px < smaller_px / 8) {
    to.scale_m_per_px = std::max(std::min(kLocateScaleMPerPx, to.scale_m_per_px), extent / smaller_px);
  }
  view_->setFollowing(false);
  may_fit_ = false;
  view_->moveTo(to, true);
}

void MainWindow::goTo() {
  GoToDialog dialog(view_->destination().center_m, this);
  if (dialog.exec() == QDialog::Accepted && dialog.point()) view_->lookAt(*dialog.point());
}

void MainWindow::setMeasuring(bool on) {
  view_->setTool(on ? static_cast<MapTool*>(measure_) : pan_);
  overlay_->setHint(on ? measure_->hint() : QString());
  actions_.find(QStringLiteral("measure"))->setChecked(on);
  actions_.find(QStringLiteral("pan"))->setChecked(!on);
}

void MainWindow::copyText(const QString& text, const QString& what) {
  QGuiApplication::clipboard()->setText(words::plainText(text));
  overlay_->toasts()->add(Mark::Good, what);
}

void MainWindow::copyCoordinates(const Eigen::Vector2d& world_m) {
  const QString text = coordinatesForClipboard(world_m);
  copyText(text, QStringLiteral("Copied %1").arg(text));
}

void MainWindow::showMapMenu(const QPoint& global_pos, const QPointF& viewport_px) {
  const Eigen::Vector2d world = view_->worldAt(viewport_px);
  QMenu menu(this);
  QAction* where = menu.addAction(coordinatesText(world, scene_->view().scale_m_per_px));
  where->setEnabled(false);
  menu.addAction(themedIcon(QStringLiteral("copy")), QStringLiteral("Copy coordinates"), this,
                 [this, world] { copyCoordinates(world); });
  menu.addAction(themedIcon(QStringLiteral("locate")), QStringLiteral("Centre here"), this,
                 [this, world] { view_->lookAt(world); });
  menu.addAction(themedIcon(QStringLiteral("measure")), QStringLiteral("Measure from here"), this,
                 [this, world] {
                   setMeasuring(true);
                   measure_->clicked(world);
                 });
  if (const auto id = scene_->submapAt(world); id && session_) {
    const QString name = QString::fromStdString(map::toText(*id));
    menu.addSeparator();
    menu.addAction(themedIcon(QStringLiteral("submaps")), QStringLiteral("Select submap %1").arg(name), this,
                   [this, id] {
                     inspector_->show();
                     inspector_->select(*id);
                   });
    menu.addAction(themedIcon(QStringLiteral("eye-off")), QStringLiteral("Hide submap %1").arg(name), this,
                   [this, id] { session_->setVisible({*id}, false); });
  }
  menu.addSeparator();
  for (const char* id : {"screenshotCopy", "screenshotSave", "export"})
    menu.addAction(actions_.find(QLatin1String(id)));
  menu.addSeparator();
  for (const char* id : {"fit", "northUp"}) menu.addAction(actions_.find(QLatin1String(id)));
  menu.exec(global_pos);
}

QImage MainWindow::mapPicture() const {
  const double ratio = view_->devicePixelRatioF();
  const QSize size = view_->viewport()->size();
  QImage image(size * ratio, QImage::Format_RGB32);
  image.setDevicePixelRatio(ratio);
  image.fill(scene_->theme().map.unknown);
  QPainter painter(&image);
  painter.setRenderHints(view_->renderHints());
  scene_->render(&painter, QRectF(QPointF(0, 0), QSizeF(size)), QRectF(QPointF(0, 0), QSizeF(size)),
                 Qt::IgnoreAspectRatio);
  return image;
}

std::optional<QString> MainWindow::saveMapPicture(const QString& path) {
  if (!firstOwnSource({path}, sourceFiles()).isEmpty()) {
    return tr("%1 is a file that this map is read from. Choose another name.")
        .arg(QDir::toNativeSeparators(path));
  }
  return scene::writePicture(mapPicture(), path);
}

void MainWindow::askAndSavePicture() {
  QSettings& settings = dependencies_.settings;
  const QString pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
  const QDir folder(
      folderToWriteInto({settings.value(QStringLiteral("screenshot/folder")).toString(), pictures}));
  const QString proposed =
      folder.filePath(QStringLiteral("mapwright-%1.png")
                          .arg(QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss"))));
  QString path = QFileDialog::getSaveFileName(this, QStringLiteral("Save the map as a picture"), proposed,
                                              QStringLiteral("PNG pictures (*.png)"));
  if (path.isEmpty()) return;
  if (!path.endsWith(QLatin1String(".png"), Qt::CaseInsensitive)) path += QLatin1String(".png");
  settings.setValue(QStringLiteral("screenshot/folder"), QFileInfo(path).absolutePath());
  if (const auto error = saveMapPicture(path)) {
    overlay_->toasts()->add(Mark::Bad, *error);
  } else {
    overlay_->toasts()->add(Mark::Good, QStringLiteral("Saved %1").arg(QDir::toNativeSeparators(path)));
  }
}

}  // namespace mapwright::window
