#include "ui/overlays/overlays_controller.h"

#include <algorithm>
#include <utility>

#include "grids/grid_pyramid.h"
#include "map/live_state.h"
#include "map/live_topics.h"
#include "overlays/overlay_check.h"
#include "overlays/overlay_merge.h"
#include "overlays/overlay_shapes.h"
#include "placing/warnings.h"
#include "sentences/absence_sentence.h"
#include "sentences/failure_sentence.h"
#include "sentences/fault_sentence.h"
#include "sentences/problem_sentence.h"
#include "session/session.h"
#include "ui/kit/actions.h"
#include "ui/kit/forms.h"
#include "ui/kit/panels.h"
#include "ui/kit/undo_stacks.h"
#include "ui/overlays/overlay_actions.h"
#include "ui/overlays/overlay_carrying.h"
#include "ui/overlays/overlay_history_dock.h"
#include "ui/overlays/overlay_review.h"
#include "ui/overlays/overlay_text.h"
#include "ui/overlays/overlay_tool.h"
#include "ui/overlays/overlays_dock.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/current_session.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/toast_stack.h"
#include "ui/view/tool_choice.h"
#include "words/listed.h"

namespace mapwright::ui {

using overlays::OverlayDocument;

namespace {

constexpr double kAroundM = 2;  // of an overlay that is shown

}  // namespace

OverlaysController::OverlaysController(WindowContext& context, const std::string& history, QObject* parent)
    : EditorController(context, parent),
      on_map_(new OverlaysOnMap(&editing_, &context.scene, this)),
      snapping_(new OverlaySnapping(&editing_, &context.scene, on_map_, this)),
      tool_(new OverlayTool(&editing_, &context.scene, on_map_, snapping_, this)),
      dock_(new OverlaysDock(&editing_, tool_, &context.window)),
      actions_(new OverlayActions(context, &editing_, tool_, snapping_, dock_, this)),
      carrying_(new OverlayCarrying(
          context, &editing_,
          {[this] { return overlays_ && overlays_->reading() ? QString() : unavailableReason(); },
           [this] { return checkOptions().radius_m; }, [this] { read(); }},
          this)),
      history_(history, context.workers),
      marks_(&context.scene),
      way_(&context.scene),
      states_(&context.scene),
      history_dock_(new OverlayHistoryDock(&history_, &context.scene, &marks_, &context.window)),
      share_(context.workers) {
  context_.panels.add(dock_, {.side = PanelPosition::Side::Right,
                              .tab = 15,
                              .menu_rank = 46,
                              .open = false,
                              .idle = lacksForGood(context_.current, {robot::Capability::OverlayEditing})});
  joinUndo(context_.undo, editing_.undoStack());
  addActions();
  addHistory();
  connect(carrying_, &OverlayCarrying::carried, this,
          [this] { context_.undo.setActiveStack(&editing_.undoStack()); });
  connect(&editing_, &edit::OverlayEditing::changed, this, &OverlaysController::onChange);
  connect(tool_, &OverlayTool::activated, this, [this] {
    context_.scene.setLayerVisible(scene::Layer::Overlays, true);
    context_.undo.setActiveStack(&editing_.undoStack());
    context_.panels.open(dock_);
    read();  // others may have changed them since
  });
  connect(tool_, &OverlayTool::refused, this,
          [this](const QString& why) { context_.overlay.toasts()->add(Mark::Warning, why); });
  OverlayTransfer* const transfer = actions_->transfer();
  connect(tool_, &OverlayTool::copyWanted, transfer, &OverlayTransfer::copy);
  connect(tool_, &OverlayTool::cutWanted, transfer, &OverlayTransfer::cut);
  connect(tool_, &OverlayTool::pasteWanted, transfer, &OverlayTransfer::paste);
  connect(dock_, &QDockWidget::visibilityChanged, this, [this](bool visible) {
    if (visible) syncMap();
  });
  connect(dock_, &OverlaysDock::modeWanted, this, [this](OverlayMode mode) {
    if (context_.tools.chosen() != tool_) context_.tools.choose(tool_);
    tool_->setMode(mode);
    context_.view.setFocus();  // its keys are those of the map
  });
  connect(dock_, &OverlaysDock::reviewWanted, this, &OverlaysController::save);
  connect(dock_, &OverlaysDock::retryWanted, this, &OverlaysController::read);
  connect(dock_, &OverlaysDock::draftWanted, this, [this] {
    if (!overlays_) return;
    overlays_->restoreDraft(tr("restore the draft"));
    if (!overlays_->inConflict()) return;
    context_.panels.open(dock_);
    dock_->showConflicts();
  });
  connect(dock_, &OverlaysDock::draftNotWanted, this, &OverlaysController::turnDownDraft);
  connect(dock_, &OverlaysDock::copyWanted, transfer, &OverlayTransfer::copy);
  connect(dock_, &OverlaysDock::cutWanted, transfer, &OverlayTransfer::cut);
  connect(dock_, &OverlaysDock::pasteWanted, transfer, [transfer] { transfer->paste(std::nullopt); });
  connect(dock_, &OverlaysDock::locateWanted, this, &OverlaysController::locate);
  connect(dock_, &OverlaysDock::wayWanted, this, &OverlaysController::showWay);
  connect(dock_->flaws(), &OverlayFlaws::optionsChanged, this, [this] {
    ++way_requests_;
    way_.show({});
    check();
  });
  connect(&editing_, &edit::OverlayEditing::selectionChanged, this, [this] {
    ++way_requests_;
    way_.show({});
  });
  connect(dock_, &OverlaysDock::placeWanted, this, [this](const Eigen::Vector2d& at_m) {
    geometry::WorldRect around;
    around.extend(at_m);
    context_.view.fit(around.grown(kAroundM), true);
  });
  refresh();
}

OverlaysController::~OverlaysController() {
  setSession(nullptr);
  delete dock_;  // they refer to members of this object
  delete carrying_;
  delete history_dock_;
}

OverlayReview* OverlaysController::review() const { return review_; }

void OverlaysController::addActions() {
  tool_action_ = context_.actions.add({.id = "overlayTool",
                                       .text = tr("Edit &overlays"),
                                       .name = tr("Tool: Edit overlays"),
                                       .icon = "overlays",
                                       .keys = {"E"},
                                       .reach = Reach::OutsideText,
                                       .tip = tr("Edit walls, regions and points of the map on the robot"),
                                       .toggle = true,
                                       .menu = {MenuGroup::Waypoints, 33},
                                       .bar = {BarGroup::Tools, 45}});
  context_.tools.add(tool_, tool_action_);
  connect(tool_action_, &QAction::triggered, this, [this](bool chosen) {
    if (chosen) context_.view.setFocus();  // its keys are those of the map
  });
}

void OverlaysController::setSession(session::Session* session) {
  if (session_) session_->mapForChecks().disconnect(this);
  EditorController::setSession(session);
  editing_.setInFile(session_ && session_->robot().isLocal());
  if (session_) {
    connect(&session_->mapForChecks(), &session::MapSlot::changed, this, &OverlaysController::refresh);
    connect(session_, &session::Session::connectionChanged, this, &OverlaysController::onLink);
    connect(&session_->robot(), &robot::Robot::mapsChanged, this, [this] {
      // Somebody wrote the file, or a file beside it.
      if (editing_.isOpen() && session_->robot().isLocal()) read();
    });
    connect(session_, &session::Session::liveChanged, this, [this](int what) {
      if (what != map::topicIndex<map::MapInfo>()) return;
      syncMap();
      const auto& info = session_->live().map_info;
      const Target* const open = openTarget();
      if (!editing_.isOpen() || !open || !open->robots || !info) return;
      if (!info->overlays_version || info->overlays_version != overlays_->held().version) read();
    });
  }
  actions_->teaching()->setSession(session);
  online_ = false;
  onLink();
  syncMap();
}

/// What could not be read while there was no connection, and what nobody knows since, is looked at again.
void OverlaysController::onLink() {
  const bool online = session_ && session_->connection().phase == robot::ConnectionPhase::Online;
  const bool came = !std::exchange(online_, online) && online;
  if (came && overlays_ && (overlays_->failure() || overlays_->inDoubt())) read();
  refresh();
}

void OverlaysController::recall(const QSettings& settings) {
  snapping_->recall(settings);
  dock_->flaws()->recall(settings);
}

void OverlaysController::remember(QSettings& settings) {
  snapping_->remember(settings);
  dock_->flaws()->remember(settings);
}

std::optional<OverlaysController::Target> OverlaysController::target() const {
  if (!session_ || !session_->robot().overlayStore()) return std::nullopt;
  const session::MapSlot& slot = session_->wholeMap();
  const map::CatalogueEntry* const current = session_->catalogue().current();
  const bool stored = current && current->key.kind == map::MapKind::Stored;
  if (slot.cells() && slot.shown().key.kind != map::MapKind::Live) {
    const map::MapKey& key = slot.shown().key;
    const bool file = session_->robot().isLocal() && key.kind == map::MapKind::File;
    if (key.kind != map::MapKind::Stored && !file) return std::nullopt;
    return Target{key, stored && current->key == key};
  }
  if (stored) return Target{current->key, true};
  // The robot may be in a map that it has not stored.
  const session::Catalogue& catalogue = session_->catalogue();
  const bool known = !catalogue.offered() || catalogue.asOf() || catalogue.failure();
  const auto& info = session_->live().map_info;
  if (known && info) return Target{{map::MapKind::Live, {}}, true, info->uid};
  return std::nullopt;
}

void OverlaysController::syncMap() {
  auto now = target();
  // Unsaved changes stay on screen while the robot cannot be asked; it may come back.
  const bool lost = session_ && !session_->robot().overlayStore() && (unsaved() || busy());
  const Target* const before = openTarget();
  if (!lost && (before ? !now || *now != *before : now.has_value())) {
    const bool other = !now || !before || !now->isSameMap(*before);
    if (other && unsaved() && keepsDraft() && !leavingAllowed())
      reportLeftMap(before->map,
                    tr("The unsaved changes to the overlays of %1 are kept as a draft.").arg(mapName()));
    if (other) closeMap();
    if (now) openTargetNow(std::move(*now));
    actions_->teaching()->setThere(overlays_ && overlays_->target().robots);
  }
  if (overlays_ && !editing_.isOpen() && !overlays_->reading() && !overlays_->failure() && wanted()) read();
  refresh();
}

void OverlaysController::openTargetNow(Target target) {
  onMapOpened(target.map);
  on_map_->setMap(target.map, target.robots);
  if (overlays_) return overlays_->setTarget(std::move(target));
  overlays_ = std::make_unique<edit::OverlaySession>(
      [this] { return session_ ? session_->robot().overlayStore() : nullptr; }, std::move(target),
      session_->robot().address(), editing_, context_.edit);
  edit::OverlaySession* const opened = overlays_.get();
  connect(opened, &edit::OverlaySession::changed, this, &OverlaysController::syncMap);
  followDrafts(*opened, dock_);
  connect(opened, &edit::OverlaySession::seen, this, &OverlaysController::onSeen);
  connect(opened, &edit::OverlaySession::opened, this, [this] {
    if (ofFile()) context_.panels.open(dock_);
    context_.undo.setActiveStack(&editing_.undoStack());
  });
  connect(opened, &edit::OverlaySession::changedThere, this, [this](qsizetype features) {
    context_.overlay.toasts()->add(
        Mark::Warning, tr("Someone else changed overlays of %1: %2.").arg(mapName(), featuresText(features)));
  });
  connect(opened, &edit::OverlaySession::merged, this, [this] {
    if (review_) reviewAnew();
  });
  connect(opened, &edit::OverlaySession::doubtSettled, this, &OverlaysController::onDoubtSettled);
  connect(opened, &edit::OverlaySession::ended, this, &OverlaysController::onOutcome);
  connect(opened, &edit::OverlaySession::failed, this, &OverlaysController::onFailed);
}

bool OverlaysController::ofFile() const {
  return session_ && session_->robot().isLocal() &&
         session_->robot().address().endsWith(QLatin1String(".geojson"), Qt::CaseInsensitive);
}

bool OverlaysController::wanted() const {
  return context_.tools.chosen() == tool_ || dock_->isVisible() || ofFile() || !offerText().isEmpty();
}

void OverlaysController::closeMap() {
  if (!overlays_) return;
  ++opened_;
  trouble_.clear();
  stay();
  if (review_) review_->close();
  leaveDraft();
  overlays_->disconnect(this);
  overlays_.reset();
}

void OverlaysController::read() {
  if (overlays_) overlays_->read();
}

void OverlaysController::onSeen(const robot::OverlayText& text, bool sent) {
  trouble_.clear();
  history_.keep(openMap(), text.version, sent ? history::Origin::Saved : history::Origin::Read, text.text,
                double(context_.edit.now().toMSecsSinceEpoch()) / 1000);
}

void OverlaysController::onDoubtSettled(bool stored) {
  stored ? reportHeld() : notSaved(tr("The overlays were not saved: the robot does not hold them."));
}

QString OverlaysController::decideText() const {
  return editing_.inFile()
             ? tr("The overlays are not saved yet: some were changed both here and in the file. Choose which "
                  "version to keep.")
             : tr("The overlays are not saved yet: some were changed both here and on the robot. Choose "
                  "which "
                  "version to keep.");
}

void OverlaysController::askToDecide() {
  EditorController::askToDecide(dock_, decideText());
  dock_->showConflicts();
}

void OverlaysController::notSaved(const QString& sentence) {
  stay();
  trouble_ = sentence;
  reportSaving(Mark::Bad, sentence);
}

void OverlaysController::save() {
  finishInput();
  if (busy() || !unsaved() || !session_) return;
  if (review_) return review_->raise();
  if (overlays_->inConflict()) return askToDecide();
  carryOut(false);
}

void OverlaysController::carryOut(bool send) {
  if (!session_ || !session_->robot().overlayStore())
    return notSaved(tr("The overlays were not saved. %1").arg(unavailableReason()));
  trouble_.clear();
  send ? overlays_->send(isStillHeld()) : overlays_->look();
}

bool OverlaysController::isStillHeld() const {
  const auto& info = session_->live().map_info;
  const robot::OverlayText& held = overlays_->held();
  return online_ && overlays_->target().robots && info && info->overlays_version &&
         info->overlays_version == held.version && info->uid == held.map_uid;
}

void OverlaysController::showReview(const jobs::OverlayOutcome* looked) {
  const OverlayDocument base = editing_.document().base(), mine = editing_.document().mine();
  const bool known = looked && looked->before.text == base.text() && mine.isSameText(looked->merge.document);
  QStringList notes;
  if (dock_->hasUnsavedFlaws()) notes << tr("Some of these have flaws: see the panel Overlays.");
  if (const QString why = notChecked(); !why.isEmpty()) notes << why;
  review_ = new OverlayReview(mapName(), session_->robot().isLocal() ? QString() : context_.current.called(),
                              base, mine, known ? looked->changes : overlays::changesBetween(base, mine),
                              words::paragraph(notes), &context_.window);
  connect(review_, &QDialog::finished, this, [this, opened = opened_](int result) {
    review_ = nullptr;
    if (opened != opened_) return;
    if (result != QDialog::Accepted) {
      stay();
    } else if (overlays_->inConflict()) {
      askToDecide();
    } else {
      carryOut(true);
    }
  });
  review_->open();
}

void OverlaysController::reviewAnew() {
  const bool conflicts = !editing_.document().conflicts().empty();
  const auto& document = editing_.document();
  if (!conflicts && unsaved() && review_->shows(document.base(), document.mine())) return;
  review_->disconnect(this);  // what waits for saving still does
  std::exchange(review_, nullptr)->reject();
  if (conflicts) return askToDecide();
  unsaved() ? showReview(nullptr) : onAllSaved();
}

/// What others did while something was being saved was told while nobody listened.
void OverlaysController::readIfChanged() {
  const auto& info = session_ ? session_->live().map_info : std::nullopt;
  const auto& held = overlays_->held();
  if (overlays_->target().robots && info && held.version && info->overlays_version > held.version)
    QMetaObject::invokeMethod(overlays_.get(), &edit::OverlaySession::read, Qt::QueuedConnection);
}

void OverlaysController::onFailed(const map::Failure& failure) {
  readIfChanged();
  if (failure.applied != map::Applied::No && !overlays_->inDoubt()) return reportHeld();
  QString why = QString::fromStdString(sentences::failureReason(failure));
  if (overlays_->unreadable().any()) why = unreadableText();
  notSaved(overlays_->inDoubt() ? tr("It is not known whether the overlays were saved. %1").arg(why)
                                : tr("The overlays were not saved. %1").arg(why));
}

void OverlaysController::onOutcome(const jobs::OverlayOutcome& outcome, bool sent) {
  readIfChanged();
  if (overlays_->inConflict() && !outcome.sent) return askToDecide();
  if (!sent && unsaved()) return showReview(&outcome);
  if (editing_.inFile() && outcome.sent) Q_EMIT fileWritten();
  const QString doubt = jobs::doubtOf(outcome);
  // What differs may be what others did to something else since.
  if (!outcome.differs.empty() && unsaved())
    return notSaved(tr("%1 They are still unsaved here.").arg(doubt));
  if (outcome.unreadable.any()) return notSaved(doubt);
  if (!outcome.sent) return reportHeld();
  doubt.isEmpty() ? reportSaving(Mark::Good, tr("Overlays of %1 saved").arg(mapName()))
                  : reportSaving(Mark::Warning, doubt);
  unsaved() ? stay() : onAllSaved();
}

QString OverlaysController::unreadableText() const {
  return tr("The overlays of this map cannot be read. %1")
      .arg(sentences::sentenceOf(overlays_->unreadable()));
}

void OverlaysController::reportHeld() {
  reportSaving(Mark::Good, tr("The robot already has these overlays."));
  onAllSaved();
}

void OverlaysController::onChange() {
  onEdited();
  ++way_requests_;
  way_.show({});
  states_.show(editing_.isOpen() ? stateMarksOf(editing_.document()) : std::vector<OverlayMark>());
  check();
  refresh();
}

const session::MapSlot* OverlaysController::mapToCheck() const {
  const Target* const open = openTarget();
  if (!session_ || !open) return nullptr;
  const auto is = [&](const session::MapSlot& slot) {
    return slot.isWhole() &&
           (slot.shown().key == open->map || (open->robots && slot.shown().key.kind == map::MapKind::Live));
  };
  if (is(session_->wholeMap())) return &session_->wholeMap();
  return is(session_->mapForChecks()) ? &session_->mapForChecks() : nullptr;
}

void OverlaysController::readMapToCheck() {
  if (!session_) return;
  const bool on_screen = mapToCheck() == &session_->wholeMap();
  const Target* const open = openTarget();
  const bool stored = open && open->map.kind == map::MapKind::Stored;
  session_->readForChecks(editing_.isOpen() && stored && !on_screen ? std::optional(open->map)
                                                                    : std::nullopt);
  const session::MapSlot* const map = mapToCheck();
  const auto cells = map ? map->cells() : nullptr;
  const bool other = std::exchange(checked_cells_, cells) != cells;
  if (!editing_.isOpen()) return;
  if (other) check();  // the map is here now
  dock_->flaws()->setNotChecked(notChecked());
}

QString OverlaysController::notChecked() const {
  if (!session_ || mapToCheck()) return {};
  const session::MapSlot& slot = session_->mapForChecks();
  if (!slot.settled()) return tr("Walls and reachability are not checked yet: the map is being read.");
  if (slot.remark())
    return tr("Walls and reachability are not checked. %1").arg(sentences::sentenceOf(*slot.remark()));
  return tr("Walls and reachability are not checked in this view. Show the whole map to check them.");
}

overlays::CheckOptions OverlaysController::checkOptions() const {
  overlays::CheckOptions options;
  options.off = dock_->flaws()->off();
  if (const session::MapSlot* const map = mapToCheck()) options.map = {map->cells(), map->reference(), false};
  const double reported = placing::radiusOf(session_->live().model);
  const double told = reported > 0 ? reported : placing::kUsualRadiusM;
  dock_->flaws()->setToldRadius(told);
  options.radius_m = dock_->flaws()->radius().value_or(told);
  return options;
}

void OverlaysController::showWay(FeatureKey key) {
  const auto keys = editing_.document().keysOfMine();
  const auto at = std::find(keys.begin(), keys.end(), key);
  if (at == keys.end() || !session_) return;
  share_.startLong([this, asked = ++way_requests_, index = std::size_t(at - keys.begin()),
                    options = checkOptions(), document = editing_.document().mine()] {
    const auto way = overlays::wayTo(index, document, options.map, options.radius_m);
    QMetaObject::invokeMethod(
        this,
        [this, asked, way] {
          if (asked != way_requests_ || !way) return;
          way_.show(marksOf(*way));
          geometry::WorldRect area;
          for (const Eigen::Vector2d& point : way->blocked) area.extend(point);
          if (!area.empty()) context_.view.fit(area.grown(kAroundM), true);
        },
        Qt::QueuedConnection);
  });
}

void OverlaysController::check() {
  if (!editing_.isOpen()) return dock_->setFlaws({});
  if (checking_) {
    check_again_ = true;
    return;
  }
  checking_ = true;
  const overlays::CheckOptions options = checkOptions();
  dock_->flaws()->setNotChecked(notChecked());
  const auto document = std::make_shared<OverlayDocument>(editing_.document().mine());
  share_.startLong([this, document, options, keys = editing_.document().keysOfMine(), opened = opened_] {
    auto found = std::make_shared<std::vector<ShownFlaw>>();
    for (const overlays::Flaw& flaw : overlays::flawsOf(*document, options)) {
      if (flaw.feature >= keys.size()) continue;
      const Feature& feature = document->features()[flaw.feature];
      QString sentence = words::about(overlayCalled(feature), sentences::sentenceOf(flaw.why));
      sentence[0] = sentence[0].toUpper();
      found->push_back({keys[flaw.feature], sentence, flaw.at_m, flaw.rule});
    }
    QMetaObject::invokeMethod(
        this,
        [this, found, opened] {
          checking_ = false;
          if (opened == opened_ && editing_.isOpen() && !check_again_) dock_->setFlaws(std::move(*found));
          if (std::exchange(check_again_, false)) check();
        },
        Qt::QueuedConnection);
  });
}

QString OverlaysController::unavailableReason() const {
  if (!session_) return tr("Connect to a robot to edit the overlays of its maps.");
  constexpr auto kEditing = robot::Capability::OverlayEditing;
  if (!session_->robot().overlayStore())
    return sentences::absenceReason(kEditing, session_->robot().unavailableReason(kEditing));
  if (!overlays_)
    return session_->robot().isLocal() ? tr("Open a map to edit its overlays.")
                                       : tr("Only stored maps have overlays. Open one in the Maps panel.");
  if (overlays_->unreadable().any()) return unreadableText();
  if (const auto& failure = overlays_->failure()) {
    return trouble_.isEmpty() ? tr("The overlays could not be read. %1")
                                    .arg(QString::fromStdString(sentences::failureReason(*failure)))
                              : trouble_;
  }
  return overlays_->reading() ? tr("Loading the overlays.") : QString();
}

void OverlaysController::refresh() {
  readMapToCheck();
  const QString sentence = unavailableReason();
  const bool failed = overlays_ && overlays_->failure();
  const bool doubt = overlays_ && overlays_->inDoubt();
  dock_->setUnavailableReason(sentence, (failed || doubt) && !busy());
  QString trouble = trouble_;
  if (trouble.isEmpty()) trouble = draftTroubleText();
  if (trouble.isEmpty() && editing_.isOpen() && failed) trouble = sentence;
  dock_->setSaving(busy(), maySave(), editing_.isOpen() ? trouble : QString());
  dock_->setOffer(editing_.isOpen() ? offerText() : QString());
  updateDecision(overlays_ && overlays_->inConflict() ? decideText() : QString());
  tool_->setUnavailableReason(sentence);
  const bool usable = overlays_ != nullptr;
  allow(tool_action_, usable, sentence);
  if (!usable && context_.tools.chosen() == tool_) context_.tools.putAway();
  updateUnsaved();
  history_dock_->openChanged();
  carrying_->update();
}

EditorController::DraftWords OverlaysController::draftWords() const {
  return {tr("There is an unsaved draft of the overlays of this map from %1: %2."),
          tr("Changes to the overlays are not backed up: save them soon. %1"),
          tr("The changes to the overlays are lost. %1")};
}

QString OverlaysController::amountText(qsizetype changes) const { return overlayChangesText(changes); }

void OverlaysController::locate(FeatureKey key) {
  const Feature* const feature = editing_.find(key);
  if (!feature) return;
  geometry::WorldRect around;
  for (const overlays::Path& path : overlays::shapesOf(*feature).paths) {
    for (const Eigen::Vector2d& point : path.points) around.extend(point);
  }
  if (!around.empty()) context_.view.fit(around.grown(kAroundM), true);
}

QString OverlaysController::mapName() const {
  const Target* const open = openTarget();
  if (!session_ || !open) return {};
  const map::CatalogueEntry* const entry = session_->catalogue().find(open->map);
  if (entry) return mapCalled(QString::fromStdString(entry->name), open->map);
  const auto& info = session_->live().map_info;
  return mapCalled(open->robots && info ? QString::fromStdString(info->name) : session_->wholeMap().name(),
                   open->map);
}

EditorController::LeaveQuestion OverlaysController::leaveQuestion() const {
  return {tr("Overlays are not saved"),
          tr("Overlays of %1: %2 not saved.")
              .arg(mapName(), overlayChangesText(qsizetype(editing_.document().unsavedCount())))};
}

void OverlaysController::finishInput() { finishTypingIn(dock_); }

void OverlaysController::discardAll(std::function<void()> then) {
  editing_.revert();
  then();
}

}  // namespace mapwright::ui

#include "moc_overlays_controller.cpp"
