#include "ui/picture/picture_controller.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QDesktopServices>
#include <QDir>
#include <QPushButton>
#include <QUrl>

#include "jobs/export_map.h"
#include "map/waypoint.h"
#include "sentences/absence_sentence.h"
#include "sentences/failure_sentence.h"
#include "sentences/fault_sentence.h"
#include "ui/kit/forms.h"
#include "ui/kit/panels.h"
#include "ui/kit/undo_stacks.h"
#include "ui/picture/copies_dialog.h"
#include "ui/picture/picture_dock.h"
#include "ui/picture/picture_drafts.h"
#include "ui/shell/current_session.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/toast_stack.h"
#include "ui/view/tool_choice.h"

namespace mapwright::window {
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
  context_.panels.add(dock_, {.side = PanelPlace::Side::Right,
                              .tab = 16,
                              .menu_rank = 46,
                              .open = false,
                              .idle = lacksForGood(context_.current, {robot::Capability::PictureEditing})});
  joinUndo(context_.undo, editing_.undoStack());
  addActions();
  connect(&editing_, &PictureEditing::cellsChanged, this, [this](const geometry::WorldRect& where) {
    if (!shown_) showCells();
    context_.scene.editedCellsChanged(where);
  });
  connect(&editing_, &PictureEditing::previewChanged, this, &PictureController::showCells);
  connect(&editing_, &PictureEditing::stateChanged, this, [this] {
    onEdited();
    if (drafts_) drafts_->touch();
    refresh();
    if (when_reverted_ && !editing_.reckoning())
      QMetaObject::invokeMethod(this, std::exchange(when_reverted_, nullptr), Qt::QueuedConnection);
  });
  connect(&editing_, &PictureEditing::stepsForgotten, this, &PictureController::reportForgotten);
  const std::size_t undo_mb =
      std::clamp<std::size_t>(context_.settings.value(kUndoMb, kUsualUndoMb).toUInt(), 16, 65'536);
  editing_.setUndoBudget(undo_mb << 20);
  connect(&editing_, &PictureEditing::mergeDone, this, &PictureController::onMerged);
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
  connect(dock_, &PictureDock::lookWanted, this, [this](Tidying what, int cells) {
    // Its keys belong to the tool, on the map.
    if (context_.tools.chosen() != tool_) context_.tools.choose(tool_);
    editing_.lookFor(what, cells);
    context_.view.setFocus();
  });
  connect(dock_, &PictureDock::mapWanted, this, [this] { context_.view.setFocus(); });
  connect(dock_, &PictureDock::saveWanted, this, &PictureController::save);
  connect(dock_, &PictureDock::stopSavingWanted, this, [this] { write_call_.cancel(); });
  connect(dock_, &PictureDock::discardWanted, this, [this] {
    doubt_.reset();  // whether it was stored does not matter any more
    editing_.revert();
  });
  connect(dock_, &PictureDock::compareWanted, this, &PictureController::compareWanted);
  connect(dock_, &PictureDock::copiesWanted, this, &PictureController::showCopies);
  connect(dock_, &PictureDock::draftWanted, this, &PictureController::restoreDraft);
  connect(dock_, &PictureDock::draftNotWanted, this, [this] {
    if (drafts_) drafts_->turnDown();
  });
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
  doubt_.reset();
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
  if (key != open_map_) {
    if (open_map_ && editing_.unsaved() && drafts_ && !leavingAllowed())
      reportLeftMap(*open_map_,
                    tr("The unsaved changes to the map %1 are kept as a draft.").arg(nameOf(*open_map_)));
    closeMap();
  }
  const bool whole = key && slot->phase() == MapSlot::Phase::Ready && slot->cells()->complete() &&
                     !slot->broken() && slot->key() == *key;
  if (open_map_ && slot->phase() == MapSlot::Phase::Failed && doubt_)
    reportDoubt(Mark::Warning,
                tr("It is still not known whether %1 was saved: its picture on the robot cannot "
                   "be loaded."));
  if (whole && !session_->robot().pictureStore()->obstacle(slot->shown())) {
    if (!open_map_) {
      onMapOpened(key);
      openOnceChecked(*slot);
    } else if (slot->cells() != seen_ && !saving_) {
      onOtherPicture(*slot);
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

void PictureController::openMap(const MapSlot& slot) {
  cell_check_ = {};
  open_map_ = slot.shown().key;
  seen_ = slot.cells();
  revision_ = slot.shown().fingerprint;
  past_revisions_.clear();
  forgetting_reported_ = false;
  ++opened_;
  editing_.open(seen_, slot.reference(), session_->robot().pictureStore()->holdsUnknown(slot.shown()));
  watchDrafts();
}

void PictureController::closeMap() {
  if (!open_map_) return;
  editing_.endStroke();  // it is kept with the rest
  if (shown_) context_.scene.setEditedCells(*open_map_, nullptr);
  shown_ = saving_ = again_ = false;
  dock_->setTravelled(std::nullopt);
  trouble_.clear();
  copy_.clear();
  conflicts_reported_ = false;
  seen_.reset();
  open_map_.reset();
  ++opened_;
  stay();
  when_reverted_ = nullptr;
  doubt_.reset();
  if (stop_reading_) stop_reading_->store(true);
  closeDrafts();
  editing_.close();
}

void PictureController::watchDrafts() {
  MapDrafts::Kind kind{.of = {session_->robot().address(), QString::fromStdString(map::toText(*open_map_)),
                              QStringLiteral("picture")},
                       .offer = tr("There is an unsaved draft of this map from %1: %2."),
                       .not_backed = tr("Changes to the map are not backed up: save them soon. %1"),
                       .lost = tr("The changes to the map are lost. %1")};
  kind.content = [this, of = kind.of]() -> edit::DraftKeeper::Job {
    if (!editing_.isOpen() || !editing_.unsaved()) return {};
    return [of, made = context_.edit.now(), now = editing_.snapshot(), saved = editing_.saved()] {
      return pictureDraftBytes(of, made, *now, *saved);
    };
  };
  kind.read = [grid = editing_.snapshot()](const QByteArray& bytes) -> std::optional<MapDrafts::Draft> {
    auto draft = pictureDraftFrom(bytes);
    const auto taken = draft ? window::restoreDraft(*draft, *grid) : std::nullopt;
    if (!taken) return std::nullopt;
    return MapDrafts::Draft{draft->made, cellsText(taken->cells), std::move(*draft), taken->cells == 0};
  };
  kind.unsaved = [this] { return editing_.unsaved(); };
  openDrafts(dock_, std::move(kind));
}

void PictureController::restoreDraft() {
  if (!drafts_ || !drafts_->offered() || !editing_.isOpen()) return;
  MapDrafts::Left left = drafts_->take();
  auto taken = window::restoreDraft(std::any_cast<const PictureDraft&>(left.draft.content), *editing_.grid());
  if (!taken) return;
  drafts_->replace(std::move(left.file));
  editing_.applyPatch(std::move(taken->patch), tr("restore the draft"));
  if (taken->elsewhere > 0)
    context_.overlay.toasts()->add(
        Mark::Warning, tr("Since this draft was made, someone else has also changed these parts of the map: "
                          "%1. Your changes are shown; use undo to see the others.")
                           .arg(cellsText(taken->elsewhere)));
}

/// The same map has arrived with another picture: saved here, or changed by someone else.
void PictureController::onOtherPicture(const MapSlot& slot) {
  seen_ = slot.cells();
  const bool fits = picture::sameShape(*editing_.grid(), *seen_) && slot.reference() == editing_.reference();
  if (fits && editing_.touched()) {
    const std::string& revision = slot.shown().fingerprint;
    // A picture saved here comes back, possibly after a later save; and so may the one before it, which was
    // being read meanwhile. What is read comes in order: an older one after the latest is someone's change.
    const bool latest = revision == revision_;
    const bool known = latest || past_revisions_.contains(revision);
    if (latest || !known) past_revisions_.clear();
    if (known && !editing_.merging()) return again_ ? onMerged(0, revision_) : settleDoubt();
    editing_.mergeTheirs(seen_, revision);
    return;
  }
  editing_.endStroke();
  const std::int64_t lost = editing_.changedCells();
  if (std::exchange(shown_, false)) context_.scene.setEditedCells(*open_map_, nullptr);
  saving_ = again_ = false;
  trouble_.clear();
  openMap(slot);
  settleDoubt();
  if (lost > 0)
    context_.overlay.toasts()->add(Mark::Bad, tr("The map was replaced by one of another size or position. "
                                                 "The unsaved changes do not fit it and were discarded: %1.")
                                                  .arg(cellsText(lost)));
}

void PictureController::showCells() {
  if (!open_map_) return;
  shown_ = true;
  const auto& preview = editing_.preview();
  std::shared_ptr<const grids::GridPyramid> cells = editing_.grid();
  if (preview) cells = preview->cells;
  context_.scene.setEditedCells(*open_map_, std::move(cells));
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
  const bool on_its_way = slot.phase() == MapSlot::Phase::Fetching || slot.phase() == MapSlot::Phase::Reading;
  return on_its_way && slot.key() == *wanted_map_;
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
  dock_->setSaving(saving_, !trouble_.isEmpty() || !drafts_ ? trouble_ : drafts_->trouble());
  dock_->setOffer(drafts_ ? drafts_->offer() : QString());
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
  if (saving_ || !editing_.unsaved() || !session_ || !open_map_) return;
  if (editing_.conflicts() > 0) return askToDecide(dock_, decideText());
  // A robot drives by it from then on.
  session_->robot().isLocal() ? send() : askToSend();
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
                      .arg(cellsText(editing_.changedCells()));
  if (!copies.isEmpty())
    about += QLatin1Char('\n') + tr("A copy of the old picture is saved in %1 as a local map. The latest %2 "
                                    "copies of each map are kept.")
                                     .arg(QDir::toNativeSeparators(copies))
                                     .arg(kMostCopies);
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
      copy_ = folder.isEmpty() ? QString() : copyPath(folder, context_.edit.now());
      return send();
    }
    stay();
  });
  sending_question_->open();
}

void PictureController::send() {
  if (saving_ || !editing_.unsaved() || !session_ || !open_map_) return;
  if (editing_.conflicts() > 0) return askToDecide(dock_, decideText());
  if (editing_.merging()) {
    again_ = true;  // it would be refused: the stored picture has already changed
    return;
  }
  if (!session_->robot().pictureStore()) return;
  saving_ = true;
  trouble_.clear();
  refresh();
  if (copy_.isEmpty()) return write();
  share_.startLong(
      [this, path = copy_, cells = editing_.saved(), place = editing_.reference(), opened = opened_] {
        const auto trouble = keepCopy(*cells, place, path);
        QMetaObject::invokeMethod(
            this,
            [this, trouble, opened] {
              if (opened == opened_) onCopied(trouble);
            },
            Qt::QueuedConnection);
      });
}

QString PictureController::copiesHere() const {
  return copiesFolder(context_.edit.drafts_folder, session_->robot().address(), mapName());
}

CopiesDialog* PictureController::copiesDialog() const { return copies_; }

void PictureController::showCopies() {
  if (copies_) return copies_->raise();
  const QString folder = allCopiesFolder(context_.edit.drafts_folder);
  if (folder.isEmpty()) return;
  copies_ = new CopiesDialog(
      folder, [this](const PictureCopy& copy) { return notPutBackReason(copy); }, &context_.window);
  copies_->setAttribute(Qt::WA_DeleteOnClose);
  connect(copies_, &CopiesDialog::putBackWanted, this, &PictureController::putBack);
  connect(copies_, &CopiesDialog::openWanted, this, [this](const QString& path) {
    copies_->accept();
    Q_EMIT fileWanted(path);
  });
  connect(copies_, &CopiesDialog::folderWanted, this,
          [](const QString& there) { QDesktopServices::openUrl(QUrl::fromLocalFile(there)); });
  connect(&editing_, &PictureEditing::stateChanged, copies_, &CopiesDialog::refresh);
  copies_->open();
  share_.startLong([this, folder, dialog = copies_] {
    auto found = std::make_shared<std::vector<PictureCopy>>(copiesKept(folder));
    QMetaObject::invokeMethod(
        this,
        [this, dialog, found] {
          if (!dialog) return;
          for (const auto& [address, called] : named_ ? named_() : Named()) {
            const QString kept_as = jobs::fileNameFrom(address);
            for (PictureCopy& copy : *found) {
              if (copy.robot == kept_as) copy.called = called;
            }
          }
          dialog->list(std::move(*found));
        },
        Qt::QueuedConnection);
  });
}

QString PictureController::notPutBackReason(const PictureCopy& copy) const {
  if (!session_ || !session_->wholeMap().cells() || copy.folder() != copiesHere())
    return tr("This is a copy of another map. To put it back, open its map from its robot first.");
  if (!editing_.isOpen()) {
    const QString why = unavailableReason();
    return why.isEmpty() ? tr("The map is loading.") : why;
  }
  return saving_ ? tr("The map is being saved.") : QString();
}

void PictureController::putBack(const PictureCopy& copy) {
  if (!notPutBackReason(copy).isEmpty()) return;
  copies_->accept();
  if (stop_reading_) stop_reading_->store(true);
  stop_reading_ = std::make_shared<std::atomic<bool>>(false);
  share_.startLong([this, copy, stop = stop_reading_, opened = opened_] {
    const auto read = std::make_shared<tl::expected<ReadCopy, QString>>(readCopy(copy.path, *stop));
    const QString when = copy.made.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss"));
    QMetaObject::invokeMethod(
        this,
        [this, when, read, opened] {
          if (opened == opened_) onCopyRead(when, *read);
        },
        Qt::QueuedConnection);
  });
}

void PictureController::onCopyRead(const QString& when, const tl::expected<ReadCopy, QString>& read) {
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
                    step = editing_.undoStack().index(), revision = revision_, opened = opened_] {
    const auto patch = std::make_shared<picture::Patch>(picture::differenceTo(*now, *cells, stop.get()));
    QMetaObject::invokeMethod(
        this,
        [this, cells, when, patch, step, revision, opened] {
          if (opened != opened_) return;
          const bool changed = step != editing_.undoStack().index() || revision != revision_ ||
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

/// Without a backup nothing is overwritten.
void PictureController::onCopied(const std::optional<Fault>& trouble) {
  if (!saving_) return;
  if (!trouble) return write();
  saving_ = false;
  reportNotWritten(tr("Nothing was sent, because the robot's map could not be backed up: %1")
                       .arg(sentences::wordsOf(*trouble)));
  syncMap();
}

void PictureController::reportNotWritten(const QString& sentence, map::Applied applied) {
  stay();
  trouble_ = sentence;
  reportSaving(Mark::Bad,
               applied == map::Applied::No ? tr("The map was not saved. %1").arg(trouble_) : trouble_);
}

/// The picture on the robot was read again after it was sent with an unknown result.
void PictureController::settleDoubt() {
  if (!doubt_) return;
  share_.startLong([this, doubt = *doubt_, now = editing_.saved(), opened = opened_] {
    const auto same = [&](const picture::EditedGrid& one) {
      return picture::sameShape(one, *now) && picture::DifferenceCount::between(one, *now).cells == 0;
    };
    const bool stored = same(*doubt.sent), before = !stored && same(*doubt.before);
    QMetaObject::invokeMethod(
        this,
        [this, stored, before, sent = doubt.sent, opened] {
          if (opened != opened_ || !doubt_ || doubt_->sent != sent) return;
          stored   ? reportDoubt(Mark::Good, tr("%1 was saved: the robot has the new picture."))
          : before ? reportDoubt(Mark::Bad, tr("%1 was not saved: the robot has the same picture as before."))
                   : reportDoubt(Mark::Warning, tr("%1 was not saved as it was sent: the robot has another "
                                                   "picture."));
          if (stored) doubt_.reset();
        },
        Qt::QueuedConnection);
  });
}

/// Once for each finding.
void PictureController::reportDoubt(Mark mark, const QString& sentence) {
  if (std::exchange(doubt_->reported, sentence) == sentence) return;
  trouble_ = mark == Mark::Good ? QString() : sentence.arg(mapName());
  reportSaving(mark, sentence.arg(mapName()));
  refresh();
}

void PictureController::write() {
  robot::PictureStore* const store = session_->robot().pictureStore();
  if (!store) {
    saving_ = false;
    return refresh();
  }
  const auto cells = editing_.snapshot();
  before_ = editing_.saved();
  write_call_ = store->write({*open_map_, cells, revision_},
                             [this, cells, opened = opened_](robot::Outcome<robot::PictureReceipt> outcome) {
                               if (opened == opened_) onWritten(cells, outcome);
                             });
  write_call_.onProgress([this, opened = opened_](robot::Progress progress) {
    if (opened != opened_ || !saving_ || !progress.of_bytes || *progress.of_bytes <= 0) return;
    dock_->setTravelled(double(progress.bytes) / double(*progress.of_bytes));
  });
  refresh();
}

void PictureController::onWritten(const std::shared_ptr<const picture::EditedGrid>& cells,
                                  const robot::Outcome<robot::PictureReceipt>& outcome) {
  saving_ = false;
  dock_->setTravelled(std::nullopt);
  const bool unknown = !outcome && outcome.error().applied == map::Applied::Maybe;
  if (outcome) {
    past_revisions_.insert(std::exchange(revision_, outcome->revision));
    Q_EMIT written();
    editing_.markSaved(cells);
    if (copy_.isEmpty()) {
      reportSaving(Mark::Good, tr("%1 saved").arg(mapName()));
    } else {
      reportSaving(Mark::Good,
                   tr("%1 saved. Previous version: %2").arg(mapName(), QDir::toNativeSeparators(copy_)),
                   {tr("Open it"), [this, copy = copy_] { Q_EMIT fileWanted(copy); }});
    }
    onAllSaved();
  } else if (outcome.error().kind == map::FailureKind::Conflict) {
    again_ = true;
    trouble_ = tr("It was changed elsewhere in the meantime and is being reloaded.");
  } else if (outcome.error().kind == map::FailureKind::Cancelled &&
             outcome.error().applied == map::Applied::No) {
    stay();
  } else if (unknown) {
    reportNotWritten(tr("It is not known whether %1 was saved. %2 A message will say so once its picture has "
                        "been read again.")
                         .arg(mapName(), QString::fromStdString(sentences::failureReason(outcome.error()))),
                     map::Applied::Maybe);
  } else {
    reportNotWritten(QString::fromStdString(sentences::sentenceOf(outcome.error())), outcome.error().applied);
  }
  // Changes that arrived during the write were ignored.
  syncMap();
  // What was read before this says nothing about it.
  doubt_ = unknown ? std::optional(Doubt{cells, before_}) : std::nullopt;
}

void PictureController::onMerged(qint64 taken, const std::string& revision) {
  revision_ = revision;
  trouble_.clear();
  const bool again = std::exchange(again_, false);
  settleDoubt();
  if (editing_.conflicts() == 0) conflicts_reported_ = false;
  if (editing_.conflicts() > 0) {
    if (!std::exchange(conflicts_reported_, true) || again) askToDecide(dock_, decideText());
  } else if (again) {
    editing_.unsaved() ? send() : onAllSaved();
  } else if (taken > 0) {
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
          tr("Changes to %1 are not saved: %2.").arg(mapName(), cellsText(editing_.changedCells()))};
}

void PictureController::discardAll(std::function<void()> then) {
  editing_.revert();
  if (!editing_.reckoning()) return then();
  when_reverted_ = std::move(then);
}

}  // namespace mapwright::window

#include "moc_picture_controller.cpp"
