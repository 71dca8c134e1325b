#include "ui/waypoints/waypoints_controller.h"

#include <algorithm>
#include <utility>

#include <QMenu>

#include "edit/open_waypoints.h"
#include "sentences/absence_sentence.h"
#include "sentences/fault_sentence.h"
#include "session/lacks_picture.h"
#include "session/session.h"
#include "ui/kit/actions.h"
#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/panels.h"
#include "ui/kit/undo_stacks.h"
#include "ui/scene/drawing.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/current_session.h"
#include "ui/view/hit_list.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/notice_bar.h"
#include "ui/view/toast_stack.h"
#include "ui/view/tool_choice.h"
#include "ui/waypoints/name_editor.h"
#include "ui/waypoints/waypoint_arranging.h"
#include "ui/waypoints/waypoint_carrying.h"
#include "ui/waypoints/waypoint_conflicts.h"
#include "ui/waypoints/waypoint_placing.h"
#include "ui/waypoints/waypoint_review.h"
#include "ui/waypoints/waypoint_text.h"
#include "ui/waypoints/waypoint_tool.h"
#include "ui/waypoints/waypoint_transfer.h"
#include "ui/waypoints/waypoints_dock.h"
#include "ui/waypoints/waypoints_on_map.h"
#include "words/listed.h"

namespace mapwright::ui {

WaypointsController::WaypointsController(WindowContext& context, QObject* parent)
    : EditorController(context, parent),
      placing_(new WaypointPlacing(context, &editing_, this)),
      on_map_(new WaypointsOnMap(&editing_, &context.scene, &context.hits, this)),
      dock_(new WaypointsDock(&editing_, &context.window)),
      tool_(new WaypointTool(&editing_, &context.scene, &context.hits, placing_->snapping(), this)),
      name_editor_(new NameEditor(context.view.viewport())),
      transfer_(nullptr),
      review_(new WaypointReview(&context.window)) {
  context_.panels.add(dock_, {.side = PanelPosition::Side::Right,
                              .tab = 15,
                              .menu_rank = 45,
                              .idle = lacksForGood(context_.current, {robot::Capability::Waypoints,
                                                                      robot::Capability::WaypointEditing})});
  connect(&context_.panels, &Panels::arranged, this, [this] {
    if (comesFirst()) context_.panels.suggest(dock_);
  });
  addActions();
  transfer_ = new WaypointTransfer(context_, &editing_, tool_, this);
  carrying_ = new WaypointCarrying(context_, &editing_, transfer_, placing_->warnings(), this);
  on_map_->setWarnings(placing_->warnings());
  dock_->setWarnings(placing_->warnings());
  placing_->arranging()->setListOrder([this] { return dock_->selectedAsListed(); });
  connect(dock_, &WaypointsDock::nextWarningWanted, placing_, &WaypointPlacing::showNextWarning);
  const auto focus_undo = [this] {
    if (list_) context_.undo.setActiveStack(&list_->document().undoStack());
  };
  connect(placing_, &WaypointPlacing::made, this, focus_undo);
  connect(carrying_, &WaypointCarrying::carried, this, focus_undo);
  connect(&editing_, &WaypointEditing::renameWanted, this, &WaypointsController::askName);
  connect(&editing_, &WaypointEditing::removalRefused, this,
          [this](const QString& why) { context_.overlay.toasts()->add(Mark::Warning, why); });
  connect(tool_, &WaypointTool::activated, this, [this] {
    context_.scene.setLayerVisible(scene::Layer::Waypoints, true);
    context_.panels.open(dock_);
    context_.view.setFocus();  // its keys are those of the map
    if (list_) context_.undo.setActiveStack(&list_->document().undoStack());
  });
  connect(dock_, &WaypointsDock::addWanted, this, [this] { addAt(context_.scene.view().center_m); });
  connect(dock_, &WaypointsDock::copyWanted, transfer_, &WaypointTransfer::copy);
  connect(dock_, &WaypointsDock::pasteWanted, transfer_, &WaypointTransfer::paste);
  // No longer needed.
  connect(review_, &WaypointReview::givenUp, this, [this] { stay(); });
  connect(dock_, &WaypointsDock::saveWanted, this, &WaypointsController::save);
  connect(dock_, &WaypointsDock::cancelWanted, this, [this] {
    if (list_) list_->cancelSaving();
  });
  connect(dock_, &WaypointsDock::retryWanted, this, [this] {
    if (list_) list_->read();
  });
  connect(dock_, &WaypointsDock::locateWanted, this, [this](const edit::Key& key) {
    if (const map::Waypoint* const point = editing_.find(key)) context_.view.lookAt(point->position_m);
  });
  connect(dock_, &WaypointsDock::decided, this,
          [this](const edit::Key& key, ConflictChoice choice) { decideConflict(editing_, key, choice); });
  NoticeBar* const notice = context_.overlay.editNotice();
  connect(notice, &NoticeBar::offerTaken, this, &WaypointsController::acceptOffer);
  connect(notice, &NoticeBar::secondTaken, this, [this] {
    if (!offerText().isEmpty()) return turnDownDraft();
    if (const auto left = nameLeft()) accepted_names_.insert(left->key);
    refresh();
  });
  // When the camera moves the line follows: further typing must not trigger commands of the map.
  connect(&context_.scene, &scene::MapScene::viewChanged, this, &WaypointsController::followNamed);
  connect(&editing_, &WaypointEditing::previewChanged, this, &WaypointsController::followNamed);
  connect(name_editor_, &NameEditor::closed, this, [this] { context_.view.setFocus(); });
  refresh();
}

WaypointsController::~WaypointsController() {
  setSession(nullptr);
  delete dock_;  // it refers to members of this object
}

void WaypointsController::addActions() {
  tool_action_ = context_.actions.add({.id = "waypointTool",
                                       .text = tr("&Waypoints"),
                                       .name = tr("Tool: Waypoints"),
                                       .icon = "waypoint",
                                       .keys = {"W"},
                                       .reach = Reach::OutsideText,
                                       .tip = tr("Add, move, turn and rename waypoints on the map"),
                                       .toggle = true,
                                       .menu = {MenuGroup::Waypoints, 10},
                                       .bar = {BarGroup::Tools, 30}});
  context_.tools.add(tool_, tool_action_);
  context_.actions.addToMapMenu(
      {MapMenuGroup::Edit, 10}, [this](QMenu& menu, const Eigen::Vector2d& world_m) {
        if (!editing_.editable()) return;
        const double reach_m = MapTool::kReachPx * context_.scene.view().scale_m_per_px;
        if (const auto key = conflictAt(*editing_.document(), world_m, reach_m)) {
          fillConflictMenu(menu, *editing_.document(), *key,
                           [this, key](ConflictChoice choice) { decideConflict(editing_, *key, choice); });
          menu.addSeparator();
        }
        addToMenu(menu, world_m);
        menu.addAction(themedIcon(QStringLiteral("waypoint")), tr("Add &waypoint here"), this,
                       [this, world_m] { addAt(world_m); });
      });
  revert_action_ = context_.actions.add({.id = "revertWaypoints",
                                         .text = tr("&Discard changes to waypoints…"),
                                         .icon = "reset",
                                         .tip = tr("Restore the waypoints as last saved"),
                                         .menu = {MenuGroup::Waypoints, 20}},
                                        this, &WaypointsController::revertAll);
}

/// What can be done with the waypoint there, if there is one.
void WaypointsController::addToMenu(QMenu& menu, const Eigen::Vector2d& world_m) {
  const std::vector<Hit> hits = context_.hits.at(world_m, MapTool::kReachPx);
  const auto hit = std::find_if(hits.begin(), hits.end(), [this](const Hit& one) {
    return one.layer == scene::Layer::Waypoints && editing_.find(one.key);
  });
  if (hit == hits.end()) return;
  // An ampersand in a name is no mnemonic.
  const QString name =
      shortWaypointName(*editing_.find(hit->key)).replace(QLatin1Char('&'), QLatin1String("&&"));
  if (!editing_.selected().contains(hit->key)) editing_.select({hit->key});
  const bool several = editing_.selected().size() > 1;
  menu.addAction(tr("Re&name %1…").arg(name), this, [this, key = hit->key] { askName(key, 0); });
  const QString stays = editing_.notRemovedReason();
  menu.setToolTipsVisible(true);
  allow(menu.addAction(
            themedIcon(QStringLiteral("trash")),
            tr("&Delete %1").arg(several ? waypointsText(qsizetype(editing_.selected().size())) : name),
            &editing_, &WaypointEditing::removeSelected),
        stays.isEmpty(), stays);
  menu.addSeparator();
}

void WaypointsController::setSession(session::Session* session) {
  EditorController::setSession(session);
  if (session_) {
    connect(session_, &session::Session::connectionChanged, this, &WaypointsController::onLink);
    onLink();
  }
  placing_->setSession(session);
  if (comesFirst()) context_.panels.suggest(dock_);
  syncMap();
  refresh();
}

bool WaypointsController::comesFirst() const {
  // Files have no live data and no submaps.
  return session_ && session_->robot().isLocal() && session_->robot().waypointStore();
}

void WaypointsController::onLink() {
  const robot::ConnectionState state = session_->connection();
  if (state.phase == robot::ConnectionPhase::Online) return review_->setLinkTrouble({});
  QStringList why{tr("There is no connection to the robot, so nothing can be sent at present.")};
  if (state.reason.any()) why << sentences::sentenceOf(state.reason);
  review_->setLinkTrouble(words::paragraph(why));
}

void WaypointsController::recall(const QSettings& settings) { placing_->recall(settings); }

void WaypointsController::remember(QSettings& settings) { placing_->remember(settings); }

void WaypointsController::syncMap() {
  const session::MapSlot* const slot = session_ ? &session_->wholeMap() : nullptr;
  std::optional<map::MapKey> key;
  // Even without a picture: a robot may have waypoints of maps whose picture it does not send.
  const bool bare = slot && session_->robot().waypointStore() &&
                    (session::lacksPicture(*slot) || session::isByRegion(session_->robot(), *slot));
  if (slot && (slot->cells() || bare)) key = session_->placesOf(*slot);
  if (slot && slot->cells()) editing_.setCell(slot->reference().resolution_m);
  const bool store_went = list_ && session_ && !session_->robot().waypointStore();
  // Unsaved changes stay on screen; the store may come back.
  if (store_went && (list_->unsaved() || list_->saving())) return refresh();
  const bool store_came = !list_ && key && session_->robot().waypointStore();
  if (key != open_map_ || store_went || store_came) {
    const auto before = open_map_;
    const bool robot_left = list_ && list_->unsaved() && !leavingAllowed() && before && key != before;
    closeMap();
    if (robot_left)
      reportLeftMap(*before, tr("The unsaved waypoints of %1 are kept as a draft.").arg(nameOf(*before)));
    onMapOpened(key);
    open_map_ = key;
    on_map_->setMap(key);
    transfer_->setMap(key);
    if (key && session_->robot().waypointStore()) openList(*key);
  }
  if (key && !session_->robot().waypointStore() && session_->robot().waypointSource()) openReadOnly();
  refresh();
}

void WaypointsController::openList(const map::MapKey& key) {
  list_ = std::make_unique<edit::OpenWaypoints>(*session_->robot().waypointStore(), key,
                                                session_->robot().address(), context_.edit);
  connect(list_.get(), &edit::OpenWaypoints::changed, this, &WaypointsController::onSavingChanged);
  followDrafts(*list_);
  connect(list_.get(), &edit::OpenWaypoints::saved, this, [this] {
    if (!list_->submission().rows().empty())
      reportSaving(Mark::Good, tr("Waypoints of %1 saved").arg(mapName()));
    onAllSaved();
  });
  connect(&list_->document(), &edit::WaypointDocument::changed, this, &WaypointsController::onChange);
  joinUndo(context_.undo, list_->document().undoStack());
  context_.undo.setActiveStack(&list_->document().undoStack());
}

void WaypointsController::openReadOnly() {
  const map::WaypointList& told = session_->wholeMap().waypoints();
  edit::Items items;
  for (const map::Waypoint& point : told.points) {
    edit::Key key = point.id;
    for (int turn = 2; items.contains(key) || key.empty(); ++turn)
      key = point.id + " #" + std::to_string(turn);
    items.emplace(std::move(key), point);
  }
  if (!shown_only_) {
    shown_only_ = std::make_unique<edit::WaypointDocument>();
    connect(shown_only_.get(), &edit::WaypointDocument::changed, this, &WaypointsController::onChange);
  }
  constexpr auto kEditing = robot::Capability::WaypointEditing;
  const QString why = sentences::absenceReason(kEditing, session_->robot().unavailableReason(kEditing));
  if (why != editing_.unavailableReason()) editing_.setDocument(shown_only_.get(), why);
  if (shown_only_->items() == items) return;
  shown_only_->reset(std::move(items));
}

void WaypointsController::addAt(const Eigen::Vector2d& world_m) {
  const edit::Gesture gesture = editing_.newGesture();
  context_.scene.setLayerVisible(scene::Layer::Waypoints, true);
  const edit::Key key = editing_.add(world_m, gesture);
  if (!key.empty()) askName(key, gesture);
}

void WaypointsController::closeMap() {
  name_editor_->loseObject();
  named_.clear();
  onEdited();
  open_map_.reset();
  review_->forget();
  on_map_->setMap(std::nullopt);
  editing_.setDocument(nullptr, {});
  dock_->setList(nullptr, {});
  shown_only_.reset();
  if (list_) {
    list_->robotGone();
    leaveDraft();
    list_->disconnect(this);
    list_->document().disconnect(this);
    list_.reset();
    accepted_names_.clear();
  }
}

void WaypointsController::onSavingChanged() {
  // The list can be edited once it has been read.
  const bool ready = list_ && list_->phase() == edit::OpenWaypoints::Phase::Ready;
  if (ready && editing_.document() != &list_->document())
    editing_.setDocument(&list_->document(), {}, list_->keeps());
  const edit::SubmissionPhase phase = list_->submission().phase();
  // Without a conflict the review has to be checked again.
  const bool to_decide = phase == edit::SubmissionPhase::Undecided && !list_->document().conflicts().empty();
  if (to_decide && !std::exchange(said_decide_, true)) askToDecide();
  if (phase != edit::SubmissionPhase::Undecided) said_decide_ = false;
  const auto& failure = list_->submission().failure();
  if (phase == edit::SubmissionPhase::Stopped && failure && failure->kind != map::FailureKind::Conflict &&
      std::exchange(reported_failure_, failure) != failure) {
    // The review shows it, and can continue.
    if (!review_->isVisible()) {
      stay();
      reportSaving(Mark::Bad, tr("Waypoints: %1").arg(notSavedText(*list_, *failure)));
    }
  }
  if (list_->saving()) reported_failure_.reset();
  refresh();
}

void WaypointsController::onChange() {
  onEdited();
  followNamed();
  refresh();
}

void WaypointsController::refresh() {
  QString sentence;
  if (!session_) {
    sentence = tr("Open a map file (Ctrl+Shift+O) to see and edit its waypoints.");
  } else if (!session_->robot().waypointStore() && !session_->robot().waypointSource()) {
    sentence = sentences::absenceReason(robot::Capability::Waypoints,
                                        session_->robot().unavailableReason(robot::Capability::Waypoints));
  } else if (!open_map_) {
    sentence = tr("Waypoints belong to a whole map. Open one in the Maps panel.");
  } else if (list_ && list_->phase() == edit::OpenWaypoints::Phase::Reading) {
    sentence = tr("Loading the waypoints.");
  } else if (list_ && list_->failure()) {
    sentence = failureText(*list_->failure());
  }
  placing_->warnings()->setZeroTurns(list_ ? list_->zeroTurns() : std::set<edit::Key>());
  dock_->setList(
      list_.get(), sentence,
      session_ ? sentences::unconfirmedOf(session_->robot(), robot::Capability::WaypointEditing) : QString());
  const bool usable = editing_.document() != nullptr;
  allow(tool_action_, usable, sentence);
  if (!usable && context_.tools.chosen() == tool_) context_.tools.putAway();
  revert_action_->setEnabled(unsaved());
  refreshNotice();
  carrying_->refresh();
  updateDecision(decideText());
  updateUnsaved();
}

void WaypointsController::refreshNotice() {
  NoticeBar* const notice = context_.overlay.editNotice();
  if (const QString trouble = draftTroubleText(); !trouble.isEmpty())
    return notice->setNotice(Mark::Bad, trouble, tr("Show"));
  if (const QString offer = offerText(); !offer.isEmpty()) {
    notice->setNotice(Mark::Warning, offer, tr("Restore"));
    notice->setSecondOffer(tr("Discard draft"));
    return;
  }
  if (list_ && !list_->document().conflicts().empty()) {
    return notice->setNotice(Mark::Warning,
                             tr("%1 changed here and elsewhere. Choose which version to keep before saving.")
                                 .arg(waypointsText(qsizetype(list_->document().conflicts().size()))),
                             tr("Show"));
  }
  if (const auto left = nameLeft()) {
    notice->setNotice(Mark::Warning, left->sentence, left->offer);
    if (left->remedy != LeftName::Remedy::SendRest) notice->setSecondOffer(tr("Keep the name"));
    return;
  }
  notice->setNotice(Mark::None, {}, {});
}

std::optional<LeftName> WaypointsController::nameLeft() const {
  const bool ready = list_ && list_->phase() == edit::OpenWaypoints::Phase::Ready && !list_->saving();
  return ready ? leftName(list_->document(), accepted_names_) : std::nullopt;
}

void WaypointsController::acceptOffer() {
  if (list_ && draftTroubleText().isEmpty()) {
    if (!offerText().isEmpty()) {
      list_->restoreDraft(tr("restore the draft"));
      context_.panels.open(dock_);
      return dock_->table()->setFocus();
    }
    const auto left = list_->document().conflicts().empty() ? nameLeft() : std::nullopt;
    if (left && left->remedy == LeftName::Remedy::SendRest) return save();
    if (left && left->remedy == LeftName::Remedy::CallItSo)
      return editing_.rename(left->key, QString::fromStdString(left->permanent));
    if (left) {
      editing_.select({left->key});
      return askName(left->key, 0);
    }
  }
  context_.panels.open(dock_);
  dock_->goToConflict();
}

void WaypointsController::askToDecide() {
  EditorController::askToDecide(dock_, decideText());
  dock_->goToConflict();
}

QString WaypointsController::decideText() const {
  const std::size_t conflicts = list_ ? list_->document().conflicts().size() : 0;
  if (conflicts == 0) return {};
  return tr("Nothing was saved: %1 changed here and elsewhere. Choose which version to keep.")
      .arg(waypointsText(qsizetype(conflicts)));
}

void WaypointsController::save() {
  finishInput();
  if (!list_) return;
  if (maySave() && !list_->document().conflicts().empty()) return askToDecide();
  if (WaypointReview::isWorthIt(*list_)) return review_->review(list_.get(), mapName());
  list_->save();
}

void WaypointsController::followNamed() {
  const auto spot = name_editor_->isOpen() ? editing_.spotOf(named_) : std::nullopt;
  if (spot) name_editor_->follow(scene::toPoint(context_.scene.view().pixelFromWorld(spot->position_m)));
}

void WaypointsController::askName(const edit::Key& key, edit::Gesture gesture) {
  const map::Waypoint* const point = editing_.find(key);
  if (!point || !editing_.editable()) return;
  if (name_editor_->isOpen() && named_ == key) return;  // it is being named
  const QPointF at = scene::toPoint(context_.scene.view().pixelFromWorld(point->position_m));
  if (!QRectF(context_.view.viewport()->rect()).contains(at)) context_.view.lookAt(point->position_m, false);
  // Continuous typing is one step, together with the creation of the waypoint.
  if (gesture == 0) gesture = editing_.newGesture();
  named_ = key;
  name_editor_->ask(scene::toPoint(context_.scene.view().pixelFromWorld(point->position_m)),
                    QString::fromStdString(point->name),
                    [this, key, gesture](const QString& name) { editing_.rename(key, name, gesture); });
}

QString WaypointsController::mapName() const {
  return session_ ? mapCalled(session_->wholeMap().name(), session_->wholeMap().key()) : QString();
}

void WaypointsController::revertAll() {
  if (!unsaved() || reportIfSaving()) return;
  if (discard_question_) return discard_question_->raise();
  discard_question_ =
      new QMessageBox(QMessageBox::Warning, tr("Discard changes"),
                      tr("Discard %1 to the waypoints of %2? This cannot be undone.")
                          .arg(changesText(qsizetype(list_->document().unsaved().size())), mapName()),
                      QMessageBox::Discard | QMessageBox::Cancel, &context_.window);
  discard_question_->setTextFormat(Qt::PlainText);
  discard_question_->setAttribute(Qt::WA_DeleteOnClose);
  discard_question_->setDefaultButton(QMessageBox::Cancel);
  connect(discard_question_, &QMessageBox::finished, this, [this](int button) {
    discard_question_ = nullptr;
    if (button == QMessageBox::Discard && list_ && !reportIfSaving()) list_->discard();
  });
  discard_question_->open();
}

EditorController::DraftWords WaypointsController::draftWords() const {
  return {tr("There is an unsaved draft of these waypoints from %1: %2."),
          tr("Changes to waypoints are not backed up: save them soon. %1"),
          tr("The changes to the waypoints are lost. %1")};
}

QString WaypointsController::amountText(qsizetype changes) const { return changesText(changes); }

EditorController::LeaveQuestion WaypointsController::leaveQuestion() const {
  return {tr("Waypoints are not saved"),
          tr("Waypoints of %1: %2 not saved.")
              .arg(mapName(), changesText(qsizetype(list_->document().unsaved().size())))};
}

void WaypointsController::finishInput() {
  name_editor_->finish();
  finishTypingIn(dock_);
}

void WaypointsController::discardAll(std::function<void()> then) {
  list_->discard();
  then();
}

}  // namespace mapwright::ui

#include "moc_waypoints_controller.cpp"
