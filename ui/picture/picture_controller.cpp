#include "ui/picture/picture_controller.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QDesktopServices>
#include <QDir>
#include <QPushButton>
#include <QUrl>

#include "map/waypoint.h"
#include "sentences/absence_sentence.h"
#include "sentences/failure_sentence.h"
#include "sentences/fault_sentence.h"
#include "session/session.h"
#include "ui/kit/actions.h"
#include "ui/kit/forms.h"
#include "ui/kit/panels.h"
#include "ui/kit/undo_stacks.h"
#include "ui/picture/copies_dialog.h"
#include "ui/picture/picture_dock.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/current_session.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/toast_stack.h"
#include "ui/view/tool_choice.h"
#include "words/file_name.h"

namespace mapwright::ui {
namespace {

using session::MapSlot;

const QString kUndoMb = QStringLiteral("picture/undo_mb");
constexpr unsigned kUsualUndoMb = 256;
constexpr double kSameResolutionM = 1e-6;

}  // namespace

PictureController::PictureController(WindowContext& context, QObject* parent)
    : EditorController(context, parent),
      editing_(context.workers),
      tool_(new PictureTool(&editing_, &context.scene, this)),
      dock_(new PictureDock(&editing_, tool_, &context.window)),
      share_(context.workers) {
  context_.panels.add(dock_, {.side = PanelPosition::Side::Right,
                              .tab = 16,
                              .menu_rank = 46,
                              .open = false,
                              .idle = lacksForGood(context_.current, {robot::Capability::PictureEditing})});
  joinUndo(context_.undo, editing_.undoStack());
  addActions();
  connect(&editing_, &edit::PictureEditing::cellsChanged, this, [this](const geometry::WorldRect& where) {
    if (!shown_) showCells();
    context_.scene.editedCellsChanged(where);
  });
  connect(&editing_, &edit::PictureEditing::previewChanged, this, &PictureController::showCells);
  connect(&editing_, &edit::PictureEditing::stateChanged, this, [this] {
    onEdited();
    refresh();
    if (when_reverted_ && !editing_.reckoning())
      QMetaObject::invokeMethod(this, std::exchange(when_reverted_, nullptr), Qt::QueuedConnection);
  });
  connect(&editing_, &edit::PictureEditing::stepsForgotten, this, &PictureController::reportForgotten);
  const std::size_t undo_mb =
      std::clamp<std::size_t>(context_.settings.value(kUndoMb, kUsualUndoMb).toUInt(), 16, 65'536);
  editing_.setUndoBudget(undo_mb << 20);
  connect(tool_, &PictureTool::activated, this, [this] {
    wanted_map_ = mapInstead();
    if (wanted_map_) session_->openMap(map::MapKey(*wanted_map_));
    context_.scene.setLayerVisible(scene::Layer::WholeMap, true);
    context_.undo.setActiveStack(&editing_.undoStack());
    context_.panels.open(dock_);
  });
  connect(tool_, &PictureTool::refused, this,
          [this](const QString& why) { context_.overlay.toasts()->add(Mark::Warning, why); });
  connect(dock_, &PictureDock::modeWanted, this, [this](PaintMode mode) {
    tool_->setMode(mode);
    if (context_.tools.chosen() != tool_) context_.tools.choose(tool_);
  });
  connect(dock_, &PictureDock::lookWanted, this, [this](edit::Tidying what, int cells) {
    // Its keys belong to the tool, on the map.
    if (context_.tools.chosen() != tool_) context_.tools.choose(tool_);
    editing_.lookFor(what, cells);
    context_.view.setFocus();
  });
  connect(dock_, &PictureDock::mapWanted, this, [this] { context_.view.setFocus(); });
  connect(dock_, &PictureDock::saveWanted, this, &PictureController::save);
  connect(dock_, &PictureDock::stopSavingWanted, this, [this] {
    if (picture_) picture_->cancelSaving();
  });
  connect(dock_, &PictureDock::discardWanted, this, [this] {
    if (picture_) picture_->endDoubt();
    editing_.revert();
  });
  connect(dock_, &PictureDock::compareWanted, this, &PictureController::compareWanted);
  connect(dock_, &PictureDock::copiesWanted, this, &PictureController::showCopies);
  connect(dock_, &PictureDock::draftWanted, this, [this] {
    if (picture_) picture_->restoreDraft(tr("restore the draft"));
  });
  connect(dock_, &PictureDock::draftNotWanted, this, &PictureController::turnDownDraft);
  connect(dock_, &PictureDock::locateConflictWanted, this, [this] {
    const geometry::WorldRect where = editing_.whereConflicts();
    if (!where.empty()) context_.view.fit(where.grown(1), true);
  });
  refresh();
}

PictureController::~PictureController() {
  setSession(nullptr);
  delete dock_;  // it refers to members of this object
}

void PictureController::addActions() {
  tool_action_ = context_.actions.add({.id = "pictureTool",
                                       .text = tr("&Edit map"),
                                       .name = tr("Tool: Edit map"),
                                       .icon = "edit-map",
                                       .keys = {"B"},
                                       .reach = Reach::OutsideText,
                                       .tip = tr("Paint free, occupied and unknown areas"),
                                       .toggle = true,
                                       .menu = {MenuGroup::Waypoints, 30},
                                       .bar = {BarGroup::Tools, 40}});
  context_.tools.add(tool_, tool_action_);
  connect(tool_action_, &QAction::triggered, this, [this](bool chosen) {
    if (chosen) context_.view.setFocus();  // its keys are those of the map
  });
  QAction* const copies = context_.actions.add(
      {.id = "pictureCopies",
       .text = tr("Cop&ies of overwritten maps…"),
       .icon = "reset",
       .tip = tr("What robots had before their maps were overwritten; it can be put back"),
       .menu = {MenuGroup::Waypoints, 31}},
      this, &PictureController::showCopies);
  allow(copies, !context_.edit.drafts_folder.isEmpty(), tr("No copies are kept here."));
}

void PictureController::setSession(session::Session* session) {
  EditorController::setSession(session);
  wanted_map_.reset();
  if (cell_check_.stop) cell_check_.stop->store(true);
  cell_check_ = {};
  if (session_) dock_->setLocal(session_->robot().isLocal());
  syncMap();
}

void PictureController::syncMap() {
  const MapSlot* const slot = session_ ? &session_->wholeMap() : nullptr;
  std::optional<map::MapKey> key;
  if (slot && slot->cells() && session_->robot().pictureStore()) key = slot->shown().key;
  if (picture_ && key != picture_->map()) {
    if (unsaved() && keepsDraft() && !leavingAllowed())
      reportLeftMap(
          picture_->map(),
          tr("The unsaved changes to the map %1 are kept as a draft.").arg(nameOf(picture_->map())));
    closeMap();
  }
  const bool whole = key && slot->phase() == MapSlot::Phase::Ready && slot->isWhole() && slot->key() == *key;
  if (picture_ && slot->phase() == MapSlot::Phase::Failed && picture_->inDoubt())
    reportDoubt(Mark::Warning,
                tr("It is still not known whether %1 was saved: its picture on the robot cannot "
                   "be loaded."));
  if (whole && !session_->robot().pictureStore()->obstacle(slot->shown())) {
    if (!picture_) {
      onMapOpened(key);
      openOnceChecked(*slot);
    } else {
      picture_->onRead(pictureOf(*slot));
    }
  }
  refresh();
}

void PictureController::openOnceChecked(const MapSlot& slot) {
  if (cell_check_.cells == slot.cells()) {
    if (cell_check_.done && !cell_check_.between) openMap(slot);
    return;
  }
  std::array<bool, 256> held{};
  for (std::size_t cell = 0; cell < held.size(); ++cell)
    held[cell] = session_->robot().pictureStore()->holdsCell(slot.shown(), std::uint8_t(cell));
  if (std::all_of(held.begin(), held.end(), [](bool is_held) { return is_held; })) return openMap(slot);
  if (cell_check_.stop) cell_check_.stop->store(true);
  cell_check_ = {slot.cells(), std::make_shared<std::atomic<bool>>(false), false, std::nullopt};
  share_.startLong([this, held, cells = cell_check_.cells, stop = cell_check_.stop] {
    const auto between = picture::firstOther(*cells, held, *stop);
    QMetaObject::invokeMethod(
        this,
        [this, stop, between] {
          if (stop != cell_check_.stop) return;
          cell_check_.done = true;
          cell_check_.between = between;
          syncMap();
        },
        Qt::QueuedConnection);
  });
}

edit::PictureSession::Picture PictureController::pictureOf(const MapSlot& slot) const {
  return {slot.cells(), slot.reference(), slot.shown().fingerprint,
          session_->robot().pictureStore()->holdsUnknown(slot.shown())};
}

void PictureController::openMap(const MapSlot& slot) {
  cell_check_ = {};
  forgetting_reported_ = false;
  ++opened_;
  picture_ = std::make_unique<edit::PictureSession>(
      [this] { return session_ ? session_->robot().pictureStore() : nullptr; }, slot.shown().key,
      session_->robot().address(), pictureOf(slot), editing_, context_.edit);
  edit::PictureSession* const opened = picture_.get();
  connect(opened, &edit::PictureSession::changed, this, &PictureController::syncMap);
  followDrafts(*opened, dock_);
  connect(opened, &edit::PictureSession::saved, this, [this] { onAllSaved(); });
  connect(opened, &edit::PictureSession::progressed, this,
          [this](double share) { dock_->setTravelled(share); });
  connect(opened, &edit::PictureSession::notCopied, this, [this](const Fault& trouble) {
    reportNotWritten(tr("Nothing was sent, because the robot's map could not be backed up: %1")
                         .arg(sentences::wordsOf(trouble)));
    syncMap();
  });
  connect(opened, &edit::PictureSession::ended, this, &PictureController::onEnded);
  connect(opened, &edit::PictureSession::merged, this, &PictureController::onMerged);
  connect(opened, &edit::PictureSession::replaced, this, &PictureController::onReplaced);
  connect(opened, &edit::PictureSession::doubtSettled, this, &PictureController::onDoubtSettled);
  connect(opened, &edit::PictureSession::restored, this, [this](qint64 elsewhere) {
    if (elsewhere == 0) return;
    context_.overlay.toasts()->add(
        Mark::Warning, tr("Since this draft was made, someone else has also changed these parts of the map: "
                          "%1. Your changes are shown; use undo to see the others.")
                           .arg(edit::cellsText(elsewhere)));
  });
}

void PictureController::closeMap() {
  if (!picture_) return;
  editing_.endStroke();  // it is kept with the rest
  if (shown_) context_.scene.setEditedCells(picture_->map(), nullptr);
  shown_ = false;
  dock_->setTravelled(std::nullopt);
  trouble_.clear();
  conflicts_reported_ = false;
  ++opened_;
  stay();
  when_reverted_ = nullptr;
  if (stop_reading_) stop_reading_->store(true);
  leaveDraft();
  picture_->disconnect(this);
  picture_.reset();
}

EditorController::DraftWords PictureController::draftWords() const {
  return {tr("There is an unsaved draft of this map from %1: %2."),
          tr("Changes to the map are not backed up: save them soon. %1"),
          tr("The changes to the map are lost. %1")};
}

QString PictureController::amountText(qsizetype changes) const { return edit::cellsText(changes); }

void PictureController::onReplaced(qint64 lost) {
  ++opened_;
  forgetting_reported_ = false;
  trouble_.clear();
  if (std::exchange(shown_, false)) context_.scene.setEditedCells(picture_->map(), nullptr);
  if (lost > 0)
    context_.overlay.toasts()->add(Mark::Bad, tr("The map was replaced by one of another size or position. "
                                                 "The unsaved changes do not fit it and were discarded: %1.")
                                                  .arg(edit::cellsText(lost)));
}

void PictureController::showCells() {
  if (!picture_) return;
  shown_ = true;
  const auto& preview = editing_.preview();
  std::shared_ptr<const grids::GridPyramid> cells = editing_.grid();
  if (preview) cells = preview->cells;
  context_.scene.setEditedCells(picture_->map(), std::move(cells));
}

std::optional<map::MapKey> PictureController::mapInstead() const {
  if (!session_ || editing_.isOpen() || !session_->robot().pictureStore()) return std::nullopt;
  const MapSlot& slot = session_->wholeMap();
  const map::CatalogueEntry* const current = session_->catalogue().current();
  if (!slot.cells() || slot.shown().key.kind != map::MapKind::Live || !current ||
      current->key.kind != map::MapKind::Stored)
    return std::nullopt;
  return current->key;
}

/// It is loading.
bool PictureController::opening() const {
  if (!session_ || editing_.isOpen()) return false;
  const MapSlot& slot = session_->wholeMap();
  if (cell_check_.cells && cell_check_.cells == slot.cells() && !cell_check_.done) return true;
  if (!wanted_map_) return false;
  const bool coming = slot.phase() == MapSlot::Phase::Fetching || slot.phase() == MapSlot::Phase::Reading;
  return coming && slot.key() == *wanted_map_;
}

void PictureController::reportForgotten() {
  if (std::exchange(forgetting_reported_, true)) return;
  context_.overlay.toasts()->add(
      Mark::Warning,
      tr("The oldest changes to this map can no longer be undone: that would take too much memory."));
}

QString PictureController::unavailableReason() const {
  if (!session_) return tr("Open a map file (Ctrl+Shift+O) to edit its picture.");
  robot::PictureStore* const store = session_->robot().pictureStore();
  constexpr auto kEditing = robot::Capability::PictureEditing;
  if (!store) return sentences::absenceReason(kEditing, session_->robot().unavailableReason(kEditing));
  if (editing_.isOpen()) return {};
  if (opening()) return tr("The map is loading.");
  if (const auto key = mapInstead()) {
    const map::CatalogueEntry* const entry = session_->catalogue().find(*key);
    return tr("This is the robot's live map. The tool (B) edits \"%1\", the stored map that the robot uses.")
        .arg(entry ? QString::fromStdString(entry->name) : QString::fromStdString(key->id));
  }
  const MapSlot& slot = session_->wholeMap();
  if (!slot.cells()) return tr("Only a whole map has a picture to edit. Open one in the Maps panel.");
  const auto obstacle = store->obstacle(slot.shown());
  if (obstacle == robot::PictureObstacle::NotStored)
    return tr("Only stored maps can be edited, not the live one.");
  if (obstacle)
    return tr("Pictures of this format are read-only. Export the map as PGM and YAML and edit that.");
  if (cell_check_.between && cell_check_.cells == slot.cells())
    return tr("Some cells of this map are neither free, occupied nor unknown but in between (%1 of 100), and "
              "the robot's map manager has no gray level for these, so the map could not be sent back. "
              "Export "
              "the map to edit it as files.")
        .arg(int(*cell_check_.between));
  if (slot.broken()) return tr("Parts of this map could not be read, so it cannot be saved.");
  return tr("The map is loading.");
}

void PictureController::refresh() {
  const QString sentence = unavailableReason();
  dock_->setUnavailableReason(sentence);
  dock_->setSaving(saving(), trouble_.isEmpty() ? draftTroubleText() : trouble_);
  dock_->setOffer(offerText());
  updateDecision(editing_.conflicts() > 0 ? decideText() : QString());
  const bool usable = sentence.isEmpty() || mapInstead() || opening();
  allow(tool_action_, usable, sentence);
  if (!usable && context_.tools.chosen() == tool_) context_.tools.putAway();
  updateUnsaved();
}

QString PictureController::decideText() {
  return tr(
      "The map is not saved yet: some cells were changed both here and elsewhere. Choose which ones to "
      "keep.");
}

void PictureController::save() {
  finishInput();
  if (saving() || !unsaved() || !session_) return;
  if (picture_->inConflict()) return askToDecide(dock_, decideText());
  // A robot drives by it from then on.
  session_->robot().isLocal() ? send({}) : askToSend();
}

void PictureController::askToSend() {
  if (sending_question_) return sending_question_->raise();
  sending_question_ =
      new QMessageBox(QMessageBox::Question, tr("Send the map to the robot"),
                      tr("Overwrite %1 on the robot %2?").arg(mapName(), context_.current.called()),
                      QMessageBox::Cancel, &context_.window);
  sending_question_->setTextFormat(Qt::PlainText);
  const QString copies = copiesHere();
  QString about = tr("%1 changed. The robot will use the new picture. It does not keep the old one.")
                      .arg(edit::cellsText(editing_.changedCells()));
  if (!copies.isEmpty())
    about += QLatin1Char('\n') + tr("A copy of the old picture is saved in %1 as a local map. The latest %2 "
                                    "copies of each map are kept.")
                                     .arg(QDir::toNativeSeparators(copies))
                                     .arg(edit::kMostCopies);
  sending_question_->setInformativeText(about);
  sending_question_->setAttribute(Qt::WA_DeleteOnClose);
  QPushButton* const send_button = sending_question_->addButton(tr("Send"), QMessageBox::AcceptRole);
  send_button->setObjectName(QStringLiteral("sendPicture"));
  sending_question_->setDefaultButton(QMessageBox::Cancel);
  sending_question_->setEscapeButton(QMessageBox::Cancel);
  connect(sending_question_, &QMessageBox::finished, this, [this, send_button, opened = opened_] {
    QMessageBox* const asked = std::exchange(sending_question_, nullptr);
    if (asked->clickedButton() == send_button && opened == opened_) {
      const QString folder = copiesHere();
      return send(folder.isEmpty() ? QString() : edit::copyPath(folder, context_.edit.now()));
    }
    stay();
  });
  sending_question_->open();
}

void PictureController::send(const QString& copy) {
  if (!picture_) return;
  if (picture_->inConflict()) return askToDecide(dock_, decideText());
  trouble_.clear();
  picture_->send(copy);
}

QString PictureController::copiesHere() const {
  return edit::copiesFolder(context_.edit.drafts_folder, session_->robot().address(), mapName());
}

CopiesDialog* PictureController::copiesDialog() const { return copies_; }

void PictureController::showCopies() {
  if (copies_) return copies_->raise();
  const QString folder = edit::allCopiesFolder(context_.edit.drafts_folder);
  if (folder.isEmpty()) return;
  copies_ = new CopiesDialog(
      folder, [this](const edit::PictureCopy& copy) { return notPutBackReason(copy); }, &context_.window);
  copies_->setAttribute(Qt::WA_DeleteOnClose);
  connect(copies_, &CopiesDialog::putBackWanted, this, &PictureController::putBack);
  connect(copies_, &CopiesDialog::openWanted, this, [this](const QString& path) {
    copies_->accept();
    Q_EMIT fileWanted(path);
  });
  connect(copies_, &CopiesDialog::folderWanted, this,
          [](const QString& there) { QDesktopServices::openUrl(QUrl::fromLocalFile(there)); });
  connect(&editing_, &edit::PictureEditing::stateChanged, copies_, &CopiesDialog::refresh);
  copies_->open();
  share_.startLong([this, folder, dialog = copies_] {
    auto found = std::make_shared<std::vector<edit::PictureCopy>>(edit::copiesKept(folder));
    QMetaObject::invokeMethod(
        this,
        [this, dialog, found] {
          if (!dialog) return;
          for (const auto& [address, called] : named_ ? named_() : Named()) {
            const QString kept_as = words::shortFileName(address, QStringLiteral("map"));
            for (edit::PictureCopy& copy : *found) {
              if (copy.robot == kept_as) copy.called = called;
            }
          }
          dialog->list(std::move(*found));
        },
        Qt::QueuedConnection);
  });
}

QString PictureController::notPutBackReason(const edit::PictureCopy& copy) const {
  if (!session_ || !session_->wholeMap().cells() || copy.folder() != copiesHere())
    return tr("This is a copy of another map. To put it back, open its map from its robot first.");
  if (!editing_.isOpen()) {
    const QString why = unavailableReason();
    return why.isEmpty() ? tr("The map is loading.") : why;
  }
  return saving() ? tr("The map is being saved.") : QString();
}

void PictureController::putBack(const edit::PictureCopy& copy) {
  if (!notPutBackReason(copy).isEmpty()) return;
  copies_->accept();
  if (stop_reading_) stop_reading_->store(true);
  stop_reading_ = std::make_shared<std::atomic<bool>>(false);
  share_.startLong([this, copy, stop = stop_reading_, opened = opened_] {
    const auto read =
        std::make_shared<tl::expected<edit::ReadCopy, QString>>(edit::readCopy(copy.path, *stop));
    const QString when = copy.made.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss"));
    QMetaObject::invokeMethod(
        this,
        [this, when, read, opened] {
          if (opened == opened_) onCopyRead(when, *read);
        },
        Qt::QueuedConnection);
  });
}

void PictureController::onCopyRead(const QString& when, const tl::expected<edit::ReadCopy, QString>& read) {
  ToastStack* const toasts = context_.overlay.toasts();
  if (!read) return toasts->add(Mark::Bad, tr("The copy cannot be put back. %1").arg(read.error()));
  const map::GridReference &there = read->place, &here = editing_.reference();
  const bool in_place =
      std::abs(there.resolution_m - here.resolution_m) < kSameResolutionM &&
      map::samePlace({there.origin.x_m, there.origin.y_m}, {here.origin.x_m, here.origin.y_m}) &&
      map::sameHeading(there.origin.yaw_rad, here.origin.yaw_rad);
  if (!in_place || !picture::sameShape(*editing_.grid(), *read->cells))
    return toasts->add(Mark::Bad,
                       tr("The copy cannot be put back: the map has another size or position now."));
  if (context_.tools.chosen() != tool_) context_.tools.choose(tool_);
  turnInto(read->cells, when);
}

void PictureController::turnInto(std::shared_ptr<const grids::GridPyramid> cells, const QString& when) {
  editing_.endStroke();
  share_.startLong([this, cells = std::move(cells), when, stop = stop_reading_, now = editing_.snapshot(),
                    step = editing_.undoStack().index(), revision = picture_->revision(), opened = opened_] {
    const auto patch = std::make_shared<picture::Patch>(picture::differenceTo(*now, *cells, stop.get()));
    QMetaObject::invokeMethod(
        this,
        [this, cells, when, patch, step, revision, opened] {
          if (opened != opened_) return;
          const bool changed = step != editing_.undoStack().index() || revision != picture_->revision() ||
                               editing_.stroking() || editing_.reckoning() || editing_.merging();
          if (changed) return turnInto(cells, when);
          const bool any = !patch->empty();
          if (any) editing_.applyPatch(std::move(*patch), tr("put back the copy of %1").arg(when));
          context_.overlay.toasts()->add(
              Mark::Good,
              any ? tr("This is the copy of %1, not saved yet. Ctrl+S sends it, Ctrl+Z takes it back.")
                        .arg(when)
                  : tr("The map already equals the copy of %1.").arg(when));
        },
        Qt::QueuedConnection);
  });
}

void PictureController::reportNotWritten(const QString& sentence, map::Applied applied) {
  stay();
  trouble_ = sentence;
  reportSaving(Mark::Bad,
               applied == map::Applied::No ? tr("The map was not saved. %1").arg(trouble_) : trouble_);
}

void PictureController::onDoubtSettled(edit::PictureSession::DoubtEnd end) {
  switch (end) {
    case edit::PictureSession::DoubtEnd::Stored:
      return reportDoubt(Mark::Good, tr("%1 was saved: the robot has the new picture."));
    case edit::PictureSession::DoubtEnd::AsBefore:
      return reportDoubt(Mark::Bad, tr("%1 was not saved: the robot has the same picture as before."));
    case edit::PictureSession::DoubtEnd::Other:
      return reportDoubt(Mark::Warning,
                         tr("%1 was not saved as it was sent: the robot has another picture."));
  }
}

/// Once for each finding.
void PictureController::reportDoubt(Mark mark, const QString& sentence) {
  if (std::exchange(doubt_reported_, sentence) == sentence) return;
  trouble_ = mark == Mark::Good ? QString() : sentence.arg(mapName());
  reportSaving(mark, sentence.arg(mapName()));
  refresh();
}

void PictureController::onSaved(const QString& copy) {
  Q_EMIT written();
  if (copy.isEmpty()) return reportSaving(Mark::Good, tr("%1 saved").arg(mapName()));
  reportSaving(Mark::Good,
               tr("%1 saved. Previous version: %2").arg(mapName(), QDir::toNativeSeparators(copy)),
               {tr("Open it"), [this, copy] { Q_EMIT fileWanted(copy); }});
}

void PictureController::onEnded(const std::optional<map::Failure>& failure, const QString& copy) {
  dock_->setTravelled(std::nullopt);
  doubt_reported_.clear();
  if (!failure) return onSaved(copy);
  if (failure->kind == map::FailureKind::Conflict) {
    trouble_ = tr("It was changed elsewhere in the meantime and is being reloaded.");
  } else if (failure->kind == map::FailureKind::Cancelled && failure->applied == map::Applied::No) {
    stay();
  } else if (failure->applied == map::Applied::Maybe) {
    reportNotWritten(tr("It is not known whether %1 was saved. %2 A message will say so once its picture has "
                        "been read again.")
                         .arg(mapName(), QString::fromStdString(sentences::failureReason(*failure))),
                     map::Applied::Maybe);
  } else {
    reportNotWritten(QString::fromStdString(sentences::sentenceOf(*failure)), failure->applied);
  }
}

void PictureController::onMerged(qint64 cells, bool again) {
  trouble_.clear();
  if (!picture_->inConflict()) conflicts_reported_ = false;
  if (picture_->inConflict()) {
    if (!std::exchange(conflicts_reported_, true) || again) askToDecide(dock_, decideText());
  } else if (cells > 0 && !again) {
    const QString told = tr("%1 was changed elsewhere. The two versions were merged.").arg(mapName());
    // Someone painting there causes this with every stroke.
    if (!context_.overlay.toasts()->texts().contains(told))
      context_.overlay.toasts()->add(Mark::Warning, told);
  }
  refresh();
}

bool PictureController::escape() {
  if (editing_.reckoning()) {
    editing_.stop();
  } else if (editing_.preview() || editing_.looking()) {
    editing_.dropPreview();
  } else {
    return false;
  }
  return true;
}

QString PictureController::mapName() const {
  return session_ ? mapCalled(session_->wholeMap().name(), session_->wholeMap().key()) : QString();
}

EditorController::LeaveQuestion PictureController::leaveQuestion() const {
  return {tr("The map is not saved"),
          tr("Changes to %1 are not saved: %2.").arg(mapName(), edit::cellsText(editing_.changedCells()))};
}

void PictureController::discardAll(std::function<void()> then) {
  editing_.revert();
  if (!editing_.reckoning()) return then();
  when_reverted_ = std::move(then);
}

}  // namespace mapwright::ui

#include "moc_picture_controller.cpp"
