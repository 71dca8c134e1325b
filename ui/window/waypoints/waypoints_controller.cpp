#include "window/waypoints/waypoints_controller.h"

#include <utility>

#include <QMenu>
#include <QMessageBox>
#include <QPushButton>

#include "scene/drawn_waypoint.h"
#include "scene/layer_item.h"
#include "sentences/absence_sentence.h"
#include "sentences/reason_sentence.h"
#include "window/look/icons.h"
#include "window/look/plain_label.h"
#include "window/map/map_overlay.h"
#include "window/map/map_view.h"
#include "window/map/notice_bar.h"
#include "window/map/toast_stack.h"
#include "window/map/tool_choice.h"
#include "window/panels.h"
#include "window/undo_stacks.h"
#include "window/waypoints/name_editor.h"
#include "window/waypoints/waypoint_text.h"
#include "window/waypoints/waypoint_tool.h"
#include "window/waypoints/waypoints_dock.h"

namespace mapwright::window {

namespace {
constexpr int kKeep = -1;  // the answer that QMessageBox has no name for
}

WaypointsController::WaypointsController(WindowContext& context, QObject* parent)
    : Controller(parent),
      context_(context),
      dock_(new WaypointsDock(&editing_, &context.window)),
      tool_(new WaypointTool(&editing_, &context.scene, &context.hits, this)),
      name_editor_(new NameEditor(context.view.viewport())) {
  context_.panels.add(dock_, {.side = PanelPlace::Side::Right, .tab = 15, .menu_rank = 45});
  context_.hits.add(scene::Layer::Waypoints, &places_);
  addActions();
  const auto draw = [this] { drawAll(); };
  connect(&editing_, &WaypointEditing::selectionChanged, this, draw);
  connect(&editing_, &WaypointEditing::previewChanged, this, draw);
  connect(&editing_, &WaypointEditing::renameWanted, this, &WaypointsController::askName);
  connect(tool_, &WaypointTool::activated, this, [this] {
    context_.scene.setLayerVisible(scene::Layer::Waypoints, true);
    context_.panels.open(dock_);
    if (list_) context_.undo.setActiveStack(&list_->document().undoStack());
  });
  connect(dock_, &WaypointsDock::addWanted, this, [this] { addAt(context_.scene.view().center_m); });
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
  connect(dock_, &WaypointsDock::decided, this, [this](const edit::Key& key, bool mine) {
    if (list_) list_->document().decide(key, mine ? edit::Side::Mine : edit::Side::Theirs, tr("take theirs"));
  });
  NoticeBar* const notice = context_.overlay.editNotice();
  connect(notice, &NoticeBar::offerTaken, this, [this] {
    if (list_ && !list_->offered().empty()) return list_->takeUp(tr("take up the draft"));
    context_.panels.open(dock_);
  });
  connect(notice, &NoticeBar::secondTaken, this, [this] {
    if (list_) list_->turnDown();
  });
  // A camera that moves would leave the line behind.
  connect(&context_.scene, &scene::MapScene::viewChanged, name_editor_, &NameEditor::finish);
  connect(name_editor_, &NameEditor::closed, this, [this] { context_.view.setFocus(); });
  refresh();
}

WaypointsController::~WaypointsController() {
  setSession(nullptr);
  delete dock_;  // it looks at what is here
}

QMessageBox* WaypointsController::question() const { return question_; }

void WaypointsController::addActions() {
  tool_action_ = context_.actions.add({.id = "waypointTool",
                                       .text = tr("&Waypoints"),
                                       .icon = "waypoint",
                                       .keys = {"W"},
                                       .reach = Reach::OutsideText,
                                       .tip = tr("Add, move, turn and rename waypoints on the map"),
                                       .toggle = true,
                                       .menu = {MenuGroup::Waypoints, 10},
                                       .bar = {BarGroup::Tools, 30}});
  tool_action_->setProperty("tip", tool_action_->toolTip());
  context_.tools.add(tool_, tool_action_);
  context_.actions.placeOnMapMenu(
      {MapMenuGroup::Edit, 10}, [this](QMenu& menu, const Eigen::Vector2d& world_m) {
        if (!editing_.editable()) return;
        menu.addAction(themedIcon(QStringLiteral("waypoint")), tr("Add &waypoint here"), this,
                       [this, world_m] { addAt(world_m); });
      });
  revert_action_ = context_.actions.add({.id = "revertWaypoints",
                                         .text = tr("&Discard changes of waypoints…"),
                                         .icon = "reset",
                                         .tip = tr("Everything as it was saved last"),
                                         .menu = {MenuGroup::Waypoints, 20}},
                                        this, &WaypointsController::revertAll);
}

void WaypointsController::setSession(session::Session* session) {
  if (session_) {
    session_->wholeMap().disconnect(this);
    session_->catalogue().disconnect(this);
    session_->robot().disconnect(this);
  }
  closeList();
  session_ = session;
  if (session_) {
    connect(&session_->wholeMap(), &session::MapSlot::changed, this, &WaypointsController::syncMap);
    // Which map the robot works with, and what can be done with its waypoints.
    connect(&session_->catalogue(), &session::Catalogue::changed, this, &WaypointsController::syncMap);
    connect(&session_->robot(), &robot::Robot::capabilitiesChanged, this, &WaypointsController::syncMap);
  }
  syncMap();
  refresh();
}

void WaypointsController::syncMap() {
  const session::MapSlot* const slot = session_ ? &session_->wholeMap() : nullptr;
  std::optional<map::MapKey> key;
  if (slot && slot->cells()) key = session_->placesOf(*slot);
  if (slot && slot->cells()) editing_.setCell(slot->reference().resolution_m);
  const bool store_went = list_ && session_ && !session_->robot().waypointStore();
  const bool store_came = !list_ && key && session_->robot().waypointStore();
  if (key != open_map_ || store_went || store_came) {
    closeList();
    open_map_ = key;
    if (key && session_->robot().waypointStore()) openList(*key);
  }
  if (key && !session_->robot().waypointStore() && session_->robot().waypointSource()) openReadOnly();
  refresh();
}

void WaypointsController::openList(const map::MapKey& key) {
  list_ = std::make_unique<edit::OpenWaypoints>(*session_->robot().waypointStore(), key,
                                                session_->robot().address(), context_.edit);
  connect(list_.get(), &edit::OpenWaypoints::changed, this, &WaypointsController::noteSaving);
  connect(list_.get(), &edit::OpenWaypoints::draftTroubleChanged, this, &WaypointsController::refresh);
  connect(list_.get(), &edit::OpenWaypoints::remarked, this, [this](const map::Reason& remark) {
    context_.overlay.toasts()->add(Mark::Warning, sentences::wordsOf(remark));
  });
  connect(list_.get(), &edit::OpenWaypoints::saved, this, [this] {
    if (list_->submission().done() > 0)
      context_.overlay.toasts()->add(Mark::Good, tr("Waypoints of %1 saved").arg(mapName()));
    // Leaving closes the list, and it is the list that is speaking.
    if (const auto then = std::exchange(when_saved_, nullptr))
      QMetaObject::invokeMethod(this, then, Qt::QueuedConnection);
  });
  connect(&list_->document(), &edit::DocumentEvents::changed, this, &WaypointsController::takeChange);
  joinUndo(context_.undo, list_->document().undoStack());
  context_.undo.setActiveStack(&list_->document().undoStack());
}

void WaypointsController::openReadOnly() {
  const map::WaypointList& told = session_->wholeMap().waypoints();
  edit::Items<map::Waypoint> items;
  for (const map::Waypoint& point : told.points) {
    edit::Key key = point.id;
    for (int turn = 2; items.contains(key) || key.empty(); ++turn)
      key = point.id + " #" + std::to_string(turn);
    items.emplace(std::move(key), point);
  }
  if (shown_only_ && shown_only_->items() == items) return;
  if (!shown_only_) {
    shown_only_ = std::make_unique<edit::WaypointDocument>();
    connect(shown_only_.get(), &edit::DocumentEvents::changed, this, &WaypointsController::takeChange);
    constexpr auto kEditing = robot::Capability::WaypointEditing;
    editing_.setDocument(shown_only_.get(),
                         sentences::whyAbsent(kEditing, session_->robot().whyNot(kEditing)));
  }
  shown_only_->reset(std::move(items));
}

void WaypointsController::addAt(const Eigen::Vector2d& world_m) {
  const edit::Gesture gesture = editing_.newGesture();
  context_.scene.setLayerVisible(scene::Layer::Waypoints, true);
  const edit::Key key = editing_.add(world_m, gesture);
  if (!key.empty()) askName(key, gesture);
}

void WaypointsController::closeList() {
  name_editor_->finish();
  may_leave_ = false;
  open_map_.reset();
  editing_.setDocument(nullptr, {});
  dock_->setList(nullptr, {});
  shown_only_.reset();
  if (list_) {
    list_->robotGone();
    // What is not saved stays as a draft; where that is impossible somebody has to know.
    if (const auto trouble = list_->unsaved() ? list_->keepDraft() : std::nullopt)
      context_.overlay.toasts()->add(
          Mark::Bad, tr("The changes of waypoints are lost. %1").arg(sentences::wordsOf(*trouble)));
    list_->disconnect(this);
    list_->document().disconnect(this);
    list_.reset();
  }
  indexAll();
  drawAll();
}

void WaypointsController::noteSaving() {
  // The list can be edited from when it has been read.
  const bool ready = list_ && list_->phase() == edit::OpenWaypoints::Phase::Ready;
  if (ready && editing_.document() != &list_->document()) {
    editing_.setDocument(&list_->document(), {});
    indexAll();
    drawAll();
  }
  const edit::SubmissionPhase phase = list_->submission().phase();
  if (phase == edit::SubmissionPhase::Undecided && !std::exchange(said_decide_, true)) {
    when_saved_ = nullptr;
    context_.overlay.toasts()->add(
        Mark::Warning,
        tr("Not saved yet: some waypoints were changed here and elsewhere. Choose which is right."));
    context_.panels.open(dock_);
  }
  if (phase != edit::SubmissionPhase::Undecided) said_decide_ = false;
  const auto& failure = list_->submission().failure();
  if (phase == edit::SubmissionPhase::Stopped && failure && failure->kind != map::FailureKind::Conflict &&
      std::exchange(told_failure_, failure) != failure) {
    when_saved_ = nullptr;
    context_.overlay.toasts()->add(Mark::Bad,
                                   tr("The waypoints are not saved. %1").arg(failureText(*failure)));
  }
  if (list_->saving()) told_failure_.reset();
  refresh();
}

void WaypointsController::takeChange(const edit::DocumentChange& change) {
  may_leave_ = false;
  if (change.everything) {
    indexAll();
  } else {
    for (const auto* keys : {&change.added, &change.changed}) {
      for (const edit::Key& key : *keys) {
        if (const map::Waypoint* const point = editing_.find(key)) places_.put(key, point->position_m);
      }
    }
    for (const edit::Key& key : change.removed) places_.remove(key);
  }
  drawAll();
  refresh();
}

void WaypointsController::indexAll() {
  places_.clear();
  if (!editing_.document()) return;
  for (const auto& [key, point] : editing_.document()->items()) places_.put(key, point.position_m);
}

void WaypointsController::drawAll() {
  const edit::WaypointDocument* const document = editing_.document();
  if (!document || !open_map_) return context_.scene.setWaypoints(std::nullopt);
  scene::DrawnWaypoints drawn{*open_map_, {}};
  drawn.points.reserve(document->items().size());
  for (const auto& [key, kept] : document->items()) {
    const auto moving = editing_.preview().find(key);
    const map::Waypoint& point = moving == editing_.preview().end() ? kept : moving->second;
    const edit::ItemState state = document->state(key);
    drawn.points.push_back({point.name.empty() ? point.id : point.name, point.position_m, point.yaw_rad,
                            state.changed_elsewhere ? scene::WaypointMark::Conflict
                            : state.sent            ? scene::WaypointMark::Sent
                            : state.unsaved         ? scene::WaypointMark::Unsaved
                                                    : scene::WaypointMark::Saved,
                            editing_.selected().contains(key)});
  }
  context_.scene.setWaypoints(std::move(drawn));
}

void WaypointsController::refresh() {
  QString sentence;
  if (!session_) {
    sentence = tr("Open a map file (Ctrl+Shift+O) to see and change its waypoints.");
  } else if (!session_->robot().waypointStore() && !session_->robot().waypointSource()) {
    sentence = sentences::whyAbsent(robot::Capability::Waypoints,
                                    session_->robot().whyNot(robot::Capability::Waypoints));
  } else if (!open_map_) {
    sentence = tr("Waypoints belong to a whole map. Open one in the panel Maps.");
  } else if (list_ && list_->phase() == edit::OpenWaypoints::Phase::Reading) {
    sentence = tr("The waypoints are being read.");
  } else if (list_ && list_->failure()) {
    sentence = failureText(*list_->failure());
  }
  dock_->setList(list_.get(), sentence);
  const bool usable = editing_.document() != nullptr;
  tool_action_->setEnabled(usable);
  tool_action_->setToolTip(usable ? tool_action_->property("tip").toString() : plainToolTip(sentence));
  if (!usable && context_.tools.chosen() == tool_) context_.tools.putAway();
  revert_action_->setEnabled(unsaved());
  refreshNotice();
  const bool changed = was_unsaved_ != unsaved() || could_save_ != maySave();
  was_unsaved_ = unsaved();
  could_save_ = maySave();
  if (changed) Q_EMIT unsavedChanged();
}

void WaypointsController::refreshNotice() {
  NoticeBar* const notice = context_.overlay.editNotice();
  if (list_ && list_->draftTrouble().any()) {
    return notice->setNotice(Mark::Bad,
                             tr("Changes of waypoints are not kept safe: save them soon. %1")
                                 .arg(sentences::wordsOf(list_->draftTrouble())),
                             tr("Show"));
  }
  if (list_ && !list_->offered().empty()) {
    notice->setNotice(Mark::Warning, offerText(list_->offered().front(), context_.edit.now()), tr("Restore"));
    notice->setSecondOffer(tr("Discard draft"));
    return;
  }
  if (list_ && !list_->document().conflicts().empty()) {
    return notice->setNotice(Mark::Warning,
                             tr("%1 changed here and elsewhere. Choose which is right before saving.")
                                 .arg(waypointsText(qsizetype(list_->document().conflicts().size()))),
                             tr("Show"));
  }
  notice->setNotice(Mark::None, {}, {});
}

void WaypointsController::save() {
  name_editor_->finish();
  // What is still being typed somewhere counts.
  if (QWidget* const typing = context_.window.focusWidget(); typing && dock_->isAncestorOf(typing))
    typing->clearFocus();
  if (list_) list_->save();
}

void WaypointsController::askName(const edit::Key& key, edit::Gesture gesture) {
  const map::Waypoint* const point = editing_.find(key);
  if (!point || !editing_.editable()) return;
  const QPointF at = scene::toPoint(context_.scene.view().pixelFromWorld(point->position_m));
  if (!QRectF(context_.view.viewport()->rect()).contains(at)) context_.view.lookAt(point->position_m, false);
  // All that is typed is one step, and one with what made the waypoint.
  if (gesture == 0) gesture = editing_.newGesture();
  name_editor_->ask(scene::toPoint(context_.scene.view().pixelFromWorld(point->position_m)),
                    QString::fromStdString(point->name),
                    [this, key, gesture](const QString& name) { editing_.rename(key, name, gesture); });
}

QString WaypointsController::mapName() const {
  return session_ ? mapCalled(session_->wholeMap().name(), session_->wholeMap().key()) : QString();
}

void WaypointsController::revertAll() {
  if (!unsaved() || question_) return;
  question_ = new QMessageBox(QMessageBox::Warning, tr("Discard changes"),
                              tr("Discard %1 of the waypoints of %2? This cannot be undone.")
                                  .arg(changesText(qsizetype(list_->document().unsaved().size())), mapName()),
                              QMessageBox::Discard | QMessageBox::Cancel, &context_.window);
  question_->setTextFormat(Qt::PlainText);
  question_->setAttribute(Qt::WA_DeleteOnClose);
  question_->setDefaultButton(QMessageBox::Cancel);
  connect(question_, &QMessageBox::finished, this, [this](int button) {
    question_ = nullptr;
    if (button == QMessageBox::Discard && list_) list_->discard();
  });
  question_->open();
}

void WaypointsController::beforeLeaving(std::function<void()> then) {
  name_editor_->finish();
  if (!unsaved() || may_leave_) return then();
  when_left_ = std::move(then);
  if (question_) return question_->raise();
  question_ =
      new QMessageBox(QMessageBox::Question, tr("Waypoints are not saved"),
                      tr("Waypoints of %1: %2 not saved.")
                          .arg(mapName(), changesText(qsizetype(list_->document().unsaved().size()))),
                      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &context_.window);
  question_->setTextFormat(Qt::PlainText);
  question_->setAttribute(Qt::WA_DeleteOnClose);
  question_->setDefaultButton(QMessageBox::Save);
  if (!context_.edit.drafts_folder.isEmpty()) {
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

void WaypointsController::answer(int button) {
  const auto then = std::exchange(when_left_, nullptr);
  if (!then || !list_) return;
  if (button == QMessageBox::Save) {
    when_saved_ = then;
    list_->save();
  } else if (button == QMessageBox::Discard) {
    list_->discard();
    then();
  } else if (button == kKeep) {
    if (const auto trouble = list_->keepDraft()) {
      context_.overlay.toasts()->add(Mark::Bad, sentences::wordsOf(*trouble));
    } else {
      may_leave_ = true;
      then();
    }
  }
}

}  // namespace mapwright::window
