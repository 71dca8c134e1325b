#include "ui/maps/files_controller.h"

#include <QDir>
#include <QDropEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMimeData>

#include "session/session.h"
#include "ui/kit/actions.h"
#include "ui/kit/folders.h"
#include "ui/kit/status_text.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/toast_stack.h"

namespace mapwright::ui {

FilesController::FilesController(WindowContext& context, PicturePlacing& placing, QObject* parent)
    : Controller(parent), context_(context), placing_(placing) {
  context_.actions.add({.id = "openFile",
                        .text = tr("&Open file…"),
                        .icon = "open",
                        .keys = {"Ctrl+Shift+O"},
                        .tip = tr("Open a map.yaml, a picture of a map or a recording from this computer"),
                        .menu = {MenuGroup::Files, 10}},
                       this, &FilesController::choose);
  // Drops on the map are handled by the window.
  context_.window.setAcceptDrops(true);
  context_.view.setAcceptDrops(false);
  context_.view.viewport()->setAcceptDrops(false);
  context_.window.installEventFilter(this);
}

void FilesController::setSession(session::Session* session) {
  if (!session) return;
  const auto address = context_.addresses.parse(session->robot().address());
  if (!address || address->path.isEmpty()) return;
  const QFileInfo opened(address->path);
  rememberMapFolder(context_.settings, opened.isDir() ? opened.absoluteFilePath() : opened.absolutePath());
}

void FilesController::choose() {
  const QString path = QFileDialog::getOpenFileName(&context_.window, tr("Open a map or a recording"),
                                                    lastMapFolder(context_.settings), mapFileFilter());
  if (path.isEmpty()) return;
  rememberMapFolder(context_.settings, QFileInfo(path).absolutePath());
  open(path);
}

void FilesController::open(const QString& path) {
  const QFileInfo info(path);
  const auto refuse = [this](const QString& sentence) {
    context_.overlay.toasts()->add(Mark::Bad, sentence);
  };
  if (!info.exists()) {
    refuse(tr("%1 does not exist.").arg(QDir::toNativeSeparators(path)));
  } else if (info.isDir() || isMapYaml(path) || isRecordingFile(path) || isOverlayFile(path) ||
             isStateFile(path)) {
    Q_EMIT addressWanted(fileAddress(path));
  } else if (isBarePicture(path)) {
    placing_.place(path, tr("Open"), [this](const QString& address) { Q_EMIT addressWanted(address); });
  } else {
    refuse(tr("%1 is neither a map nor a recording. Choose a map.yaml, a picture (PNG, PGM, BMP), overlays "
              "(GeoJSON), a state file of Cartographer (.pbstream), an MCAP file or a bag (.bag, .db3).")
               .arg(plainWords(info.fileName(), 120)));
  }
}

bool FilesController::eventFilter(QObject* watched, QEvent* event) {
  if (watched != &context_.window) return Controller::eventFilter(watched, event);
  if (event->type() == QEvent::DragEnter || event->type() == QEvent::Drop) {
    auto* const drop = static_cast<QDropEvent*>(event);  // a QDragEnterEvent is one too
    const QString path = droppedMap(drop->mimeData()->urls());
    const bool enters = event->type() == QEvent::DragEnter;
    if (!enters) context_.overlay.setHint(context_.view.tool()->hint());
    event->setAccepted(false);
    if (path.isEmpty()) return true;
    drop->acceptProposedAction();
    enters ? context_.overlay.setHint(
                 (isRecordingFile(path) ? tr("Drop to play this recording") : tr("Drop to open this map")))
           : open(path);
    return true;
  }
  if (event->type() == QEvent::DragLeave) {
    context_.overlay.setHint(context_.view.tool()->hint());
    return true;
  }
  return Controller::eventFilter(watched, event);
}

}  // namespace mapwright::ui

#include "moc_files_controller.cpp"
