#include "window/picture/picture_controller.h"

#include <utility>

#include <QMessageBox>
#include <QPushButton>

#include "sentences/absence_sentence.h"
#include "sentences/failure_sentence.h"
#include "sentences/reason_sentence.h"
#include "window/look/plain_label.h"
#include "window/map/map_overlay.h"
#include "window/map/map_view.h"
#include "window/map/toast_stack.h"
#include "window/map/tool_choice.h"
#include "window/panels.h"
#include "window/picture/picture_dock.h"
#include "window/picture/picture_drafts.h"
#include "window/picture/picture_text.h"
#include "window/picture/picture_tool.h"
#include "window/undo_stacks.h"

namespace mapwright::window {

using session::MapSlot;

namespace {
constexpr int kKeep = -1;  // the answer that QMessageBox has no name for
}

PictureController::PictureController(WindowContext& context, QObject* parent)
    : Controller(parent),
      context_(context),
      editing_(context.workers),
      tool_(new PictureTool(&editing_, &context.scene, this)),
      dock_(new PictureDock(&editing_, tool_, &context.window)) {
  context_.panels.add(dock_, {.side = PanelPlace::Side::Right, .tab = 16, .menu_rank = 46, .open = false});
  joinUndo(context_.undo, editing_.undoStack());
  addActions();
  connect(&editing_, &PictureEditing::cellsChanged, this, [this](const geometry::WorldRect& where) {
    if (!shown_) showCells();
    context_.scene.editedCellsChanged(where);
  });
  connect(&editing_, &PictureEditing::previewChanged, this, &PictureController::showCells);
  connect(&editing_, &PictureEditing::stateChanged, this, [this] {
    may_leave_ = false;
    if (drafts_) drafts_->touch();
    refresh();
  });
  connect(&editing_, &PictureEditing::mergeDone, this, &PictureController::noteMerged);
  connect(tool_, &PictureTool::activated, this, [this] {
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
  connect(dock_, &PictureDock::saveWanted, this, &PictureController::save);
  connect(dock_, &PictureDock::discardWanted, &editing_, &PictureEditing::revert);
  connect(dock_, &PictureDock::compareWanted, this, &PictureController::compareWanted);
  connect(dock_, &PictureDock::draftWanted, this, [this] {
    if (drafts_) drafts_->takeUp();
  });
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
  delete dock_;  // it looks at what is here
}

QMessageBox* PictureController::question() const { return question_; }

void PictureController::addActions() {
  tool_action_ = context_.actions.add({.id = "pictureTool",
                                       .text = tr("&Edit map"),
                                       .icon = "edit-map",
                                       .keys = {"B"},
                                       .reach = Reach::OutsideText,
                                       .tip = tr("Paint free, occupied and unknown ground"),
                                       .toggle = true,
                                       .menu = {MenuGroup::Waypoints, 30},
                                       .bar = {BarGroup::Tools, 40}});
  tool_action_->setProperty("tip", tool_action_->toolTip());
  context_.tools.add(tool_, tool_action_);
}

void PictureController::setSession(session::Session* session) {
  if (session_) session_->wholeMap().disconnect(this);
  if (session_) session_->robot().disconnect(this);
  closeMap();
  session_ = session;
  if (session_) {
    connect(&session_->wholeMap(), &MapSlot::changed, this, &PictureController::syncMap);
    connect(&session_->robot(), &robot::Robot::capabilitiesChanged, this, &PictureController::syncMap);
  }
  syncMap();
}

void PictureController::syncMap() {
  const MapSlot* const slot = session_ ? &session_->wholeMap() : nullptr;
  std::optional<map::MapKey> key;
  if (slot && slot->cells() && session_->robot().pictureStore()) key = slot->shown().key;
  if (key != open_map_) closeMap();
  const bool whole = key && slot->phase() == MapSlot::Phase::Ready && slot->cells()->complete() &&
                     !slot->broken() && slot->key() == *key;
  if (whole && !session_->robot().pictureStore()->obstacle(slot->shown())) {
    if (!open_map_) {
      openMap(*slot);
    } else if (slot->cells() != seen_ && !saving_) {
      takeOther(*slot);
    }
  }
  refresh();
}

void PictureController::openMap(const MapSlot& slot) {
  open_map_ = slot.shown().key;
  seen_ = slot.cells();
  revision_ = slot.shown().fingerprint;
  own_revisions_.clear();
  ++opened_;
  editing_.open(seen_, slot.reference(), session_->robot().pictureStore()->holdsUnknown(slot.shown()));
  watchDrafts();
}

void PictureController::closeMap() {
  if (!open_map_) return;
  if (shown_) context_.scene.setEditedCells(*open_map_, nullptr);
  shown_ = saving_ = again_ = false;
  trouble_.clear();
  seen_.reset();
  open_map_.reset();
  ++opened_;
  when_saved_ = nullptr;
  keepDraft();
  editing_.close();
}

void PictureController::watchDrafts() {
  drafts_.reset();
  may_leave_ = false;
  if (context_.edit.drafts_folder.isEmpty()) return;
  drafts_ = std::make_unique<PictureDrafts>(
      &editing_,
      edit::DraftIdentity{session_->robot().address(), QString::fromStdString(map::toText(*open_map_)),
                          kPictureDraft},
      context_.edit, context_.workers);
  connect(drafts_.get(), &PictureDrafts::changed, this, [this] {
    if (drafts_->offered()) context_.panels.open(dock_);
    refresh();
  });
  connect(drafts_.get(), &PictureDrafts::remarked, this,
          [this](const QString& sentence) { context_.overlay.toasts()->add(Mark::Warning, sentence); });
}

/// What is not saved stays as a draft; where that is impossible somebody has to know.
void PictureController::keepDraft() {
  if (!drafts_) return;
  const bool unsaved = editing_.unsaved();
  if (const auto trouble = drafts_->keep(); trouble && unsaved)
    context_.overlay.toasts()->add(
        Mark::Bad, tr("The changes of the map are lost. %1").arg(sentences::wordsOf(*trouble)));
  drafts_.reset();
}

/// The same map has come with another picture: what was saved here, or what somebody else has made of it.
void PictureController::takeOther(const MapSlot& slot) {
  seen_ = slot.cells();
  const bool touched = editing_.unsaved() || editing_.undoStack().count() > 0;
  // What was saved here comes back, and may be overtaken by what was saved after it.
  const std::string& revision = slot.shown().fingerprint;
  const bool known = revision == revision_ || own_revisions_.contains(revision);
  if (touched && known && slot.reference() == editing_.reference()) return;
  if (touched && picture::sameShape(*editing_.grid(), *seen_) && slot.reference() == editing_.reference()) {
    coming_revision_ = revision;
    editing_.takeIn(seen_);
    return;
  }
  const std::int64_t lost = editing_.changedCells();
  if (std::exchange(shown_, false)) context_.scene.setEditedCells(*open_map_, nullptr);
  saving_ = again_ = false;
  trouble_.clear();
  openMap(slot);
  if (lost > 0)
    context_.overlay.toasts()->add(
        Mark::Bad,
        tr("The map has been replaced by one of another size or place. What was not saved fits it no "
           "more and is gone: %1.")
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

QString PictureController::whyNot() const {
  if (!session_) return tr("Open a map file (Ctrl+Shift+O) to edit its picture.");
  robot::PictureStore* const store = session_->robot().pictureStore();
  constexpr auto kEditing = robot::Capability::PictureEditing;
  if (!store) return sentences::whyAbsent(kEditing, session_->robot().whyNot(kEditing));
  if (editing_.isOpen()) return {};
  const MapSlot& slot = session_->wholeMap();
  if (!slot.cells()) return tr("Pictures belong to a whole map. Open one in the panel Maps.");
  if (const auto obstacle = store->obstacle(slot.shown())) return obstacleText(*obstacle);
  if (slot.broken()) return tr("Parts of this map could not be read, so it cannot be saved again.");
  return tr("The map is being read.");
}

void PictureController::refresh() {
  const QString sentence = whyNot();
  dock_->setWhyNot(sentence);
  dock_->setSaving(saving_, !trouble_.isEmpty() || !drafts_ ? trouble_ : drafts_->trouble());
  dock_->setOffer(drafts_ ? drafts_->offer() : QString());
  const bool usable = sentence.isEmpty();
  tool_action_->setEnabled(usable);
  tool_action_->setToolTip(usable ? tool_action_->property("tip").toString() : plainToolTip(sentence));
  if (!usable && context_.tools.chosen() == tool_) context_.tools.putAway();
  if (std::exchange(was_unsaved_, unsaved()) != unsaved()) Q_EMIT unsavedChanged();
}

void PictureController::askToDecide() {
  when_saved_ = nullptr;
  context_.overlay.toasts()->add(
      Mark::Warning,
      tr("The map is not saved yet: some cells were changed here and elsewhere. Choose which are right."));
  context_.panels.open(dock_);
}

void PictureController::save() {
  editing_.endStroke();
  if (saving_ || !editing_.unsaved() || !session_ || !open_map_) return;
  if (editing_.conflicts() > 0) return askToDecide();
  robot::PictureStore* const store = session_->robot().pictureStore();
  if (!store) return;
  saving_ = true;
  trouble_.clear();
  const auto cells = editing_.snapshot();
  store->write({*open_map_, cells, revision_},
               [this, cells, opened = opened_](robot::Outcome<robot::PictureReceipt> outcome) {
                 if (opened == opened_) noteWritten(cells, outcome);
               });
  refresh();
}

void PictureController::noteWritten(const std::shared_ptr<const picture::EditedGrid>& cells,
                                    const robot::Outcome<robot::PictureReceipt>& outcome) {
  saving_ = false;
  if (outcome) {
    revision_ = outcome->revision;
    own_revisions_.insert(revision_);
    Q_EMIT written();
    editing_.noteSaved(cells);
    context_.overlay.toasts()->add(Mark::Good, tr("%1 saved").arg(mapName()));
    // Leaving ends the session, and it is its robot that is speaking.
    if (const auto then = std::exchange(when_saved_, nullptr))
      QMetaObject::invokeMethod(this, then, Qt::QueuedConnection);
  } else if (outcome.error().kind == map::FailureKind::Conflict) {
    again_ = true;
    trouble_ = tr("It has changed elsewhere meanwhile, and is being read again.");
  } else {
    when_saved_ = nullptr;
    trouble_ = QString::fromStdString(sentences::sentenceOf(outcome.error()));
    context_.overlay.toasts()->add(Mark::Bad, tr("The map is not saved. %1").arg(trouble_));
  }
  // What came while it was being written was not looked at.
  syncMap();
}

void PictureController::noteMerged(qint64 taken) {
  revision_ = coming_revision_;
  trouble_.clear();
  const bool again = std::exchange(again_, false);
  if (editing_.conflicts() > 0) {
    askToDecide();
  } else if (again) {
    if (editing_.unsaved()) {
      save();
    } else if (const auto then = std::exchange(when_saved_, nullptr)) {
      QMetaObject::invokeMethod(this, then, Qt::QueuedConnection);
    }
  } else if (taken > 0) {
    context_.overlay.toasts()->add(Mark::Warning,
                                   tr("%1 has changed elsewhere. Both are put together.").arg(mapName()));
  }
  refresh();
}

QString PictureController::mapName() const {
  return session_ ? mapCalled(session_->wholeMap().name(), session_->wholeMap().key()) : QString();
}

void PictureController::beforeLeaving(std::function<void()> then) {
  editing_.endStroke();
  if (!unsaved() || may_leave_) return then();
  when_left_ = std::move(then);
  if (question_) return question_->raise();
  question_ = new QMessageBox(
      QMessageBox::Question, tr("The map is not saved"),
      tr("Changes of %1 are not saved: %2.").arg(mapName(), cellsText(editing_.changedCells())),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &context_.window);
  question_->setTextFormat(Qt::PlainText);
  question_->setAttribute(Qt::WA_DeleteOnClose);
  question_->setDefaultButton(QMessageBox::Save);
  if (drafts_) {
    QPushButton* const keep = question_->addButton(tr("Keep as draft"), QMessageBox::ActionRole);
    keep->setObjectName(QStringLiteral("keepDraft"));
    keep->setToolTip(tr("They are offered again when this map is opened"));
  }
  connect(question_, &QMessageBox::finished, this, [this] {
    QMessageBox* const asked = std::exchange(question_, nullptr);
    QAbstractButton* const clicked = asked->clickedButton();
    if (!clicked) return answer(QMessageBox::Cancel);
    const auto standard = asked->standardButton(clicked);
    answer(standard == QMessageBox::NoButton ? kKeep : int(standard));
  });
  question_->open();
}

void PictureController::answer(int button) {
  const auto then = std::exchange(when_left_, nullptr);
  if (!then || !open_map_) return;
  if (button == QMessageBox::Save) {
    when_saved_ = then;
    save();
  } else if (button == QMessageBox::Discard) {
    editing_.revert();
    then();
  } else if (button == kKeep && drafts_) {
    if (const auto trouble = drafts_->keep()) {
      context_.overlay.toasts()->add(Mark::Bad, sentences::wordsOf(*trouble));
    } else {
      may_leave_ = true;
      then();
    }
  }
}

}  // namespace mapwright::window
