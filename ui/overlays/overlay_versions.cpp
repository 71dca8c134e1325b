// The part of OverlaysController that is about earlier versions.
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

#include "disk/written_file.h"
#include "sentences/fault_sentence.h"
#include "session/session.h"
#include "ui/kit/folders.h"
#include "ui/kit/panels.h"
#include "ui/overlays/overlay_history_dock.h"
#include "ui/overlays/overlays_controller.h"
#include "ui/overlays/overlays_dock.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/toast_stack.h"

namespace mapwright::ui {
namespace {

constexpr double kAroundChangeM = 2;

}  // namespace

void OverlaysController::addHistory() {
  context_.panels.add(history_dock_,
                      {.side = PanelPosition::Side::Right, .tab = 16, .menu_rank = 47, .open = false});
  history_dock_->setOpen([this]() -> std::optional<OverlayHistoryDock::Open> {
    if (!editing_.isOpen()) return std::nullopt;
    return OverlayHistoryDock::Open{openMap(), [this] { return editing_.document().mine(); },
                                    editing_.editable()};
  });
  connect(dock_, &OverlaysDock::historyWanted, this, [this] {
    context_.panels.open(history_dock_);
    if (overlays_) history_dock_->showMap(openMap());
  });
  connect(history_dock_, &OverlayHistoryDock::areaWanted, this,
          [this](const geometry::WorldRect& area) { context_.view.fit(area.grown(kAroundChangeM), true); });
  connect(history_dock_, &OverlayHistoryDock::restoreVersionWanted, this,
          &OverlaysController::restoreVersion);
  connect(history_dock_, &OverlayHistoryDock::saveAsWanted, this, &OverlaysController::saveVersion);
  connect(&history_, &OverlayHistory::troubleChanged, this, [this] {
    if (!history_.trouble().any()) return;
    context_.overlay.toasts()->add(Mark::Warning, tr("This version of the overlays is not in the history. %1")
                                                      .arg(sentences::sentenceOf(history_.trouble())));
  });
}

history::MapName OverlaysController::openMap() const {
  const robot::OverlayText& held = overlays_->held();
  return history::mapName(session_ ? session_->robot().address().toStdString() : std::string(),
                          map::toText(overlays_->target().map),
                          held.map_uid.empty() ? overlays_->target().uid : held.map_uid, held.map_name);
}

void OverlaysController::restoreVersion(const overlays::OverlayDocument& version, const QString& called) {
  if (!editing_.editable()) return;
  editing_.become(version, tr("bring back %1").arg(called));
  context_.panels.open(dock_);
  context_.overlay.toasts()->add(Mark::Good,
                                 tr("The overlays are here as in %1. Nothing was sent yet.").arg(called));
}

void OverlaysController::saveVersion(const QString& suggested, const std::string& text) {
  QString path = QFileDialog::getSaveFileName(
      &context_.window, tr("Save this version"),
      QDir(folderToWriteInto({lastMapFolder(context_.settings)})).filePath(suggested),
      tr("GeoJSON (*.geojson)"));
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += QLatin1String(".geojson");
  if (const auto why = disk::writeFile(path.toStdString(), text)) {
    context_.overlay.toasts()->add(Mark::Bad, sentences::wordsOf(disk::notWritten(*why)));
  } else {
    context_.overlay.toasts()->add(Mark::Good, tr("Saved %1").arg(QDir::toNativeSeparators(path)));
  }
}

}  // namespace mapwright::ui
