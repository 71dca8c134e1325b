// MainWindow: map files, and what is exported.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <QDir>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QFutureWatcher>
#include <QMimeData>
#include <QPromise>
#include <QStandardPaths>
#include <QThreadPool>

#include "robot/address.h"
#include "window/dialogs/export_dialog.h"
#include "window/dialogs/picture_dialog.h"
#include "window/files/folders.h"
#include "window/files/map_files.h"
#include "window/main_window.h"
#include "window/map/map_overlay.h"
#include "window/map/map_view.h"
#include "window/map/toast_stack.h"

namespace mapwright::window {

namespace {

const QString kFolderKey = QStringLiteral("files/folder");
const QString kExportFolderKey = QStringLiteral("export/folder");

/// Where the pixels of the view lie in the world.
map::GridReference referenceOf(const geometry::ViewTransform& view, const QSize& pixels) {
  map::GridReference reference;
  reference.width = pixels.width();
  reference.height = pixels.height();
  reference.resolution_m = view.scale_m_per_px * view.width_px / std::max(1, pixels.width());
  const Eigen::Vector2d corner = view.worldFromPixel({0, double(view.height_px)});
  reference.origin = {corner.x(), corner.y(), -view.rotation_rad};
  return reference;
}

}  // namespace

PictureDialog* MainWindow::pictureDialog() const { return picture_dialog_; }
ExportDialog* MainWindow::exportDialog() const { return export_dialog_; }

void MainWindow::createFileActions() {
  const auto on = [this](QAction* action, auto&& what) { connect(action, &QAction::triggered, this, what); };
  on(actions_.add(QStringLiteral("Robot"), QStringLiteral("openFile"), tr("&Open map file…"),
                  QStringLiteral("open"), {QKeySequence(QStringLiteral("Ctrl+Shift+O"))}, Reach::Everywhere,
                  tr("Open a map.yaml or a picture of a map from this computer")),
     [this] { chooseFile(); });
  on(actions_.add(QStringLiteral("Map"), QStringLiteral("export"), tr("E&xport…"), QStringLiteral("export"),
                  {QKeySequence(QStringLiteral("Ctrl+E"))}, Reach::Everywhere,
                  tr("Write the map on screen into a file")),
     [this] { exportMap(); });
}

QString MainWindow::lastMapFolder() const {
  return folderToReadFrom({dependencies_.settings.value(kFolderKey).toString(),
                           QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation),
                           QDir::homePath()});
}

void MainWindow::chooseFile() {
  const QString path =
      QFileDialog::getOpenFileName(this, tr("Open a map file"), lastMapFolder(), mapFileFilter());
  if (path.isEmpty()) return;
  dependencies_.settings.setValue(kFolderKey, QFileInfo(path).absolutePath());
  openPath(path);
}

void MainWindow::openPath(const QString& path) {
  const QFileInfo info(path);
  const auto refuse = [this](const QString& sentence) { overlay_->toasts()->add(Mark::Bad, sentence); };
  if (!info.exists()) {
    refuse(tr("%1 is not there.").arg(QDir::toNativeSeparators(path)));
  } else if (info.isDir() || isMapYaml(path)) {
    goToAddress(fileAddress(path));
  } else if (isBarePicture(path)) {
    placePicture(path, tr("Open"), [this](const QString& address) { goToAddress(address); });
  } else {
    refuse(tr("%1 is no map: a map.yaml or a picture (PNG, PGM, BMP) is needed.")
               .arg(info.fileName().left(120)));
  }
}

void MainWindow::placePicture(const QString& path, const QString& accept_text,
                              const std::function<void(const QString&)>& then) {
  const quint64 asked = ++pictures_asked_;
  const auto know = [this, path, accept_text, then](const QStringList& yamls) {
    yamls.size() == 1 ? then(fileAddress(yamls.front())) : askPlacement(path, yamls, accept_text, then);
  };
  if (!dependencies_.yamls_naming) return know({});
  // A folder on a slow share must not hold the window.
  auto* watcher = new QFutureWatcher<QStringList>(this);
  connect(watcher, &QFutureWatcherBase::finished, this, [this, watcher, asked, know] {
    watcher->deleteLater();
    if (asked == pictures_asked_) know(watcher->result());
  });
  auto promise = std::make_shared<QPromise<QStringList>>();
  watcher->setFuture(promise->future());
  QThreadPool::globalInstance()->start([promise, path, look = dependencies_.yamls_naming] {
    promise->start();
    promise->addResult(look(path));
    promise->finish();
  });
}

void MainWindow::askPlacement(const QString& path, const QStringList& named_by, const QString& accept_text,
                              const std::function<void(const QString&)>& then) {
  delete picture_dialog_;
  picture_dialog_ = new PictureDialog(path, named_by, accept_text, this);
  picture_dialog_->setAttribute(Qt::WA_DeleteOnClose);
  connect(picture_dialog_, &QDialog::accepted, this, [this, path, then] {
    if (const auto placement = picture_dialog_->placement()) then(fileAddress(path, placement));
  });
  picture_dialog_->open();
}

void MainWindow::goToAddress(const QString& address) {
  if (const auto error = connectTo(address)) overlay_->toasts()->add(Mark::Bad, *error);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (droppedMap(event->mimeData()->urls()).isEmpty()) return;
  event->acceptProposedAction();
  overlay_->setHint(tr("Drop to open this map"));
}

void MainWindow::dragLeaveEvent(QDragLeaveEvent*) { overlay_->setHint(view_->tool()->hint()); }

void MainWindow::dropEvent(QDropEvent* event) {
  overlay_->setHint(view_->tool()->hint());
  const QString path = droppedMap(event->mimeData()->urls());
  if (path.isEmpty()) return;
  event->acceptProposedAction();
  openPath(path);
}

std::vector<std::string> MainWindow::sourceFiles() const {
  if (!session_) return {};
  const session::MapSlot& slot = session_->wholeMap();
  std::vector<std::string> files =
      robot::localFiles(session_->robot().address(), slot.key().id, slot.shown().path);
  if (files.empty() || slot.shown().path.empty() || !dependencies_.yamls_naming) return files;
  for (const QString& yaml : dependencies_.yamls_naming(QString::fromStdString(slot.shown().path)))
    files.push_back(yaml.toStdString());
  return files;
}

void MainWindow::exportMap() {
  if (!session_) return;
  const session::MapSlot& slot = session_->wholeMap();
  ExportOffer offer;
  offer.submaps = scene_->placedTextures();
  double finest = std::numeric_limits<double>::infinity();
  for (const render::PlacedTexture& placed : offer.submaps) {
    if (placed.texture->resolutionM() > 0) finest = std::min(finest, placed.texture->resolutionM());
  }
  if (std::isfinite(finest)) offer.submap_resolution_m = finest;
  if (slot.cells() && slot.cells()->complete() && slot.settled()) {
    offer.whole = WholeMapExport{slot.cells(), slot.reference()};
  } else {
    offer.why_not_whole = slot.cells() ? tr("The map is still being read.")
                                       : tr("No whole map is open, and no submaps are there.");
  }
  offer.prefers_submaps = !offer.whole || !scene_->layerVisible(scene::Layer::WholeMap);
  offer.name = slot.cells() && !offer.prefers_submaps ? mapCalled(slot.name(), slot.key())
                                                      : session_->robot().identity().name;
  if (offer.name.trimmed().isEmpty()) offer.name = QStringLiteral("map");
  offer.view = [this] {
    const QImage picture = mapPicture();
    return ViewExport{picture, referenceOf(scene_->view(), picture.size())};
  };
  offer.sources = sourceFiles();
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  offer.folder = folderToWriteInto({dependencies_.settings.value(kExportFolderKey).toString(), documents});
  delete export_dialog_;
  export_dialog_ = new ExportDialog(std::move(offer), this);
  export_dialog_->setAttribute(Qt::WA_DeleteOnClose);
  connect(export_dialog_, &ExportDialog::exported, this, [this](const QString& path) {
    dependencies_.settings.setValue(kExportFolderKey, QFileInfo(path).absolutePath());
    overlay_->toasts()->add(Mark::Good, tr("Exported to %1").arg(QDir::toNativeSeparators(path)));
  });
  export_dialog_->open();
}

}  // namespace mapwright::window
