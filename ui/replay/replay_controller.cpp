#include "ui/replay/replay_controller.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QAbstractItemView>
#include <QAction>
#include <QDesktopServices>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QKeyEvent>
#include <QMenu>
#include <QStandardPaths>
#include <QUrl>

#include "disk/file_error.h"
#include "disk/written_file.h"
#include "jobs/export_map.h"
#include "sentences/fault_sentence.h"
#include "session/session.h"
#include "ui/kit/actions.h"
#include "ui/kit/folders.h"
#include "ui/kit/panels.h"
#include "ui/replay/events_dock.h"
#include "ui/replay/range_export_dialog.h"
#include "ui/replay/timeline_axis.h"
#include "ui/replay/timeline_dock.h"
#include "ui/replay/track_on_map.h"
#include "ui/reporting/report_job.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/current_session.h"
#include "ui/shell/notices.h"
#include "ui/shell/replay_clock.h"
#include "ui/shell/unsaved_changes.h"
#include "ui/shell/viewpoint.h"
#include "ui/view/hit_list.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/replay_state.h"
#include "ui/view/toast_stack.h"
#include "words/file_name.h"
#include "words/listed.h"

namespace mapwright::ui {

using robot::ConnectionPhase;

namespace {

const QString kReadAllKey = QStringLiteral("replay/readAll");
const QString kFollowEventsKey = QStringLiteral("replay/followEvents");
const QString kRangeFolderKey = QStringLiteral("replay/exportFolder");
const QString kSavingEvents = QStringLiteral("events");
const QString kEventsFolderKey = QStringLiteral("replay/eventsFolder");
const QString kReporting = QStringLiteral("report");
const QString kReportFolderKey = QStringLiteral("replay/reportFolder");
const QString kHiddenEventsKey = QStringLiteral("replay/hiddenEvents");
constexpr double kNearTrackPx = 10, kRoomAroundTrackM = 8;
constexpr double kOnePassS = 3;  // poses within this time belong to one pass of a place

}  // namespace

template <typename What>
QAction* ReplayController::entry(const char* id, const QString& text, const char* icon, const char* key,
                                 const QString& tip, What&& what) {
  QList<QKeySequence> keys;
  if (*key) keys << QKeySequence(QLatin1String(key));
  QAction* const action = context_.actions.add(tr("Replay"), QLatin1String(id), text, QLatin1String(icon),
                                               keys, Reach::Everywhere, tip);
  connect(action, &QAction::triggered, this, std::forward<What>(what));
  menu_->addAction(action);
  of_open_bag_.push_back(action);
  return action;
}

ReplayController::ReplayController(WindowContext& context, MakeRobot make_robot, QObject* parent)
    : Controller(parent),
      context_(context),
      make_robot_(std::move(make_robot)),
      clock_(new ReplayClock({}, this)),
      dock_(new TimelineDock(*clock_, &context.window)),
      events_(new EventsDock(*clock_, &context.window)) {
  context_.panels.add(dock_,
                      {.side = PanelPosition::Side::Bottom, .tab = 40, .menu_rank = 48, .open = false});
  context_.panels.add(events_,
                      {.side = PanelPosition::Side::Bottom, .tab = 45, .menu_rank = 49, .open = false});
  addActions();
  connectEvents();
  connect(dock_, &TimelineDock::backWanted, this, &ReplayController::back);
  connect(dock_, &TimelineDock::exportWanted, this, &ReplayController::exportRange);
  connect(clock_, &ReplayClock::opened, this, &ReplayController::onOpened);
  connect(clock_, &ReplayClock::timeChanged, this, &ReplayController::showPose);
  connect(clock_, &ReplayClock::timeChanged, this, &ReplayController::onLink);
  connect(clock_, &ReplayClock::stateChanged, this, [this] {
    showPose();
    chooseMaps();
    refresh();
  });
  connect(&context_.current, &CurrentSession::stateChanged, this, &ReplayController::refresh);
  auto* const track = new TrackOnMap(*clock_, context_.scene, this);
  connect(track, &TrackOnMap::shown, this, &ReplayController::fitTrack);
  connect(&context_.view, &MapView::movedByHand, this, [this] { fits_track_ = false; });
  context_.view.installEventFilter(this);
  context_.view.viewport()->installEventFilter(this);
  // What no widget has a use for comes there.
  context_.window.installEventFilter(this);
}

void ReplayController::addActions() {
  menu_ = new QMenu(tr("Re&play"), &context_.window);
  menu_->setToolTipsVisible(true);
  context_.actions.addToMenu({MenuGroup::Link, 40}, menu_->menuAction());
  entry("replayPlay", tr("&Play or pause"), "play", "Ctrl+Space", tr("Play or pause the bag"),
        [this] { clock_->togglePlaying(); });
  entry("replayBackwards", tr("&Backwards or forwards"), "", "", tr("Reverse the direction"),
        [this] { clock_->setSpeed(-clock_->speed()); });
  entry("replayFaster", tr("&Faster"), "", "", tr("Play faster"), [this] { dock_->faster(1); });
  entry("replaySlower", tr("&Slower"), "", "", tr("Play slower"), [this] { dock_->faster(-1); });
  menu_->addSeparator();
  entry("replayMessageBack", tr("Previous &message"), "message-back", "", tr("To the previous message"),
        [this] { clock_->stepMessage(-1); });
  entry("replayMessageForward", tr("Next m&essage"), "message-forward", "", tr("To the next message"),
        [this] { clock_->stepMessage(1); });
  entry("replayEventBack", tr("Previous e&vent"), "event-back", "", tr("To the previous event"),
        [this] { dock_->goToNextEvent(-1); });
  entry("replayEventForward", tr("&Next event"), "event-forward", "", tr("To the next event"),
        [this] { dock_->goToNextEvent(1); });
  entry("replayTime", tr("Go to a &time…"), "goto", "Ctrl+T", tr("Type the time to go to"), [this] {
    context_.panels.open(dock_);
    dock_->askForTime();
  });
  menu_->addSeparator();
  end_loop_ = entry("replayEndLoop", tr("End the &loop"), "", "", tr("Continue playing beyond the loop"),
                    [this] { clock_->setLoop(std::nullopt); });
  read_all_ =
      context_.actions.addToggle(tr("Replay"), QStringLiteral("replayReadAll"), tr("&Read the whole bag"), {},
                                 {}, Reach::Everywhere, tr("Read to the end to find all events"));
  read_all_->setChecked(true);
  menu_->addAction(read_all_);
  connect(read_all_, &QAction::toggled, this, [this](bool all) {
    if (replay::Reading* const reading = clock_->reading()) reading->setWhole(all);
    events_->setReadsAll(all);
  });
  entry("replayExport", tr("E&xport a range…"), "export", "",
        tr("Write a part of the bag or the path of the robot to a file"), [this] { exportRange(); });
  entry("replayReport", tr("Report of t&his moment…"), "", "",
        tr("Write what the robot believed at this time, with map and curves, as one HTML file"),
        [this] { reportMoment(); });
  menu_->addSeparator();
  back_ = context_.actions.add(tr("Replay"), QStringLiteral("replayBack"), tr("Back to the r&obot"),
                               QStringLiteral("robot"), {}, Reach::Everywhere, tr("End the replay"));
  connect(back_, &QAction::triggered, this, &ReplayController::back);
  menu_->addAction(back_);
  for (const auto signal : {&ReplayClock::opened, &ReplayClock::closed, &ReplayClock::stateChanged})
    connect(clock_, signal, this, &ReplayController::refreshActions);
  back_->setEnabled(false);
  refreshActions();
}

void ReplayController::refreshActions() {
  for (QAction* const action : of_open_bag_) action->setEnabled(clock_->isOpen());
  end_loop_->setEnabled(clock_->loop().has_value());
}

ReplayController::~ReplayController() {
  if (range_dialog_) range_dialog_->leaveBag();
  clock_->detach();
}

void ReplayController::connectEvents() {
  connect(dock_, &TimelineDock::listWanted, this, [this] { context_.panels.open(events_); });
  connect(dock_, &TimelineDock::eventsChanged, this,
          [this] { events_->setEvents(dock_->view()->content().events); });
  connect(events_, &EventsDock::readAllWanted, this, [this] { read_all_->setChecked(true); });
  connect(events_, &EventsDock::copyWanted, this,
          [this](const QString& text, const QString& said) { copyText(context_.overlay, text, said); });
  connect(events_, &EventsDock::saveWanted, this, &ReplayController::saveEvents);
}

RangeExportDialog* ReplayController::rangeDialog() const { return range_dialog_; }

void ReplayController::exportRange() {
  const replay::Reading* const reading = clock_->reading();
  session::Session* const session = context_.current.session();
  const replay::ReplayRobot* const robot = replayOf(session);
  if (!reading || !robot || !session->robot().bagLibrary()) return;
  if (range_dialog_) return range_dialog_->raise();
  RangeOffer offer;
  offer.source = {session->robot().bagLibrary(), reading->key(), {}};
  offer.address = robot->address();
  offer.robot_kind = context_.addresses.kindOf(offer.address);
  const auto address = context_.addresses.parse(offer.address);
  if (reading->key().kind == robot::BagKind::File && address)
    offer.source.recording = address->path.toStdString();
  offer.name = QString::fromStdString(reading->key().name);
  offer.first_s = clock_->start();
  offer.last_s = clock_->end();
  offer.loop = clock_->loop();
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  offer.folder = folderToWriteInto({context_.settings.value(kRangeFolderKey).toString(), documents});
  offer.workers = context_.workers;
  offer.now = [clock = clock_] { return clock->at(); };
  range_dialog_ = new RangeExportDialog(std::move(offer), &context_.window);
  range_dialog_->setAttribute(Qt::WA_DeleteOnClose);
  connect(range_dialog_, &RangeExportDialog::exported, this,
          [this](const QString& path, const QString& sentence) {
            context_.settings.setValue(kRangeFolderKey, QFileInfo(path).absolutePath());
            context_.overlay.toasts()->add(Mark::Good, sentence);
          });
  range_dialog_->show();
}

void ReplayController::reportMoment() {
  const replay::Reading* const reading = clock_->reading();
  if (!reading) return;
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  const QDir folder(folderToWriteInto({context_.settings.value(kReportFolderKey).toString(), documents}));
  const QString proposed =
      words::fileName(QStringLiteral("%1 %2.html")
                          .arg(QString::fromStdString(reading->key().name), incident::utcText(clock_->at())),
                      QStringLiteral("report.html"));
  QString path = QFileDialog::getSaveFileName(&context_.window, tr("Report of this moment"),
                                              folder.filePath(proposed), tr("Web pages (*.html)"));
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += QLatin1String(".html");
  context_.settings.setValue(kReportFolderKey, QFileInfo(path).absolutePath());
  reportMoment(path);
}

void ReplayController::reportMoment(const QString& path) {
  const replay::Reading* const reading = clock_->reading();
  if (!reading) return;
  ToastStack* const toasts = context_.overlay.toasts();
  if (report_) return toasts->add(Mark::Busy, tr("The previous report is still being written."));
  const QString address = context_.current.address();
  const auto source = context_.addresses.parse(address);
  if (source && !jobs::firstOwnSource({path}, {source->path.toStdString()}).isEmpty())
    return toasts->add(
        Mark::Bad, tr("%1 is the recording itself. Choose another name.").arg(QDir::toNativeSeparators(path)),
        {}, kReporting);
  reporting::ReportOrder order;
  order.run.robot = [this, address] { return make_robot_(address); };
  order.run.bag = reading->key();
  // The timeline begins with a whole second.
  order.run.at_s = std::max(clock_->at(), reading->info()->start_s);
  order.path = path;
  order.existing = disk::existingNow(path.toStdString());
  report_ = std::make_unique<reporting::ReportJob>(std::move(order), context_.workers);
  toasts->add(Mark::Busy, tr("The report is being written…"), {}, kReporting);
  // Queued: the one that has ended is deleted.
  connect(
      report_.get(), &reporting::ReportJob::ended, this,
      [this, toasts] {
        const std::unique_ptr<reporting::ReportJob> job = std::move(report_);
        if (!job->error().isEmpty()) return toasts->add(Mark::Bad, job->error(), {}, kReporting);
        const QUrl file = QUrl::fromLocalFile(job->path());
        toasts->add(Mark::Good, tr("Saved %1").arg(QDir::toNativeSeparators(job->path())),
                    {tr("Open"), [file] { QDesktopServices::openUrl(file); }}, kReporting);
      },
      Qt::QueuedConnection);
  report_->start();
}

void ReplayController::saveEvents() {
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  const QDir folder(folderToWriteInto({context_.settings.value(kEventsFolderKey).toString(), documents}));
  QString path =
      QFileDialog::getSaveFileName(&context_.window, tr("Save the listed events"),
                                   folder.filePath(QStringLiteral("events.csv")), tr("Tables (*.csv)"));
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += QLatin1String(".csv");
  context_.settings.setValue(kEventsFolderKey, QFileInfo(path).absolutePath());
  if (const auto fault = disk::writeFile(path.toStdString(), events_->model()->csv())) {
    context_.overlay.toasts()->add(Mark::Bad, sentences::wordsOf(disk::notWritten(*fault)), {},
                                   kSavingEvents);
  } else {
    context_.overlay.toasts()->add(Mark::Good, tr("Saved %1").arg(QDir::toNativeSeparators(path)), {},
                                   kSavingEvents);
  }
}

void ReplayController::openBag(const robot::BagKey& key) {
  auto origin = make_robot_(context_.current.address());
  if (!origin) return context_.overlay.toasts()->add(Mark::Bad, origin.error());
  open(std::move(*origin), key);
}

void ReplayController::open(std::unique_ptr<robot::Robot> origin, const robot::BagKey& key) {
  show(std::make_unique<replay::ReplayRobot>(std::move(origin), key, followedReading()));
}

void ReplayController::open(std::unique_ptr<robot::Robot> origin, const std::string& name) {
  show(std::make_unique<replay::ReplayRobot>(std::move(origin), name, followedReading()));
}

void ReplayController::show(std::unique_ptr<robot::Robot> replay) {
  // Shared, because the callback has to be copyable.
  context_.unsaved.whenMayLeaveRobot([this, made = std::make_shared<std::unique_ptr<robot::Robot>>(std::move(
                                                replay))] { context_.current.begin(std::move(*made)); });
}

void ReplayController::back() {
  if (!replayOf(context_.current.session())) return;
  const QString before = context_.current.addressBefore();
  if (!before.isEmpty()) return Q_EMIT backWanted(before);
  context_.unsaved.whenMayLeaveRobot([this] { context_.current.leave(); });
}

void ReplayController::setSession(session::Session* session) {
  const bool was_replay = clock_->isOpen() || !dock_was_open_;
  // Readers of the bag must not outlive its robot.
  if (range_dialog_) range_dialog_->leaveBag();
  clock_->detach();
  context_.scene.setPoseBetween(std::nullopt);
  auto* const robot = session ? qobject_cast<replay::ReplayRobot*>(&session->robot()) : nullptr;
  if (robot) {
    dock_was_open_ = dock_was_open_ && dock_->toggleViewAction()->isChecked();
    connect(robot, &robot::Robot::connectionChanged, this, &ReplayController::onConnection);
    connect(robot, &replay::ReplayRobot::jumped, this, &ReplayController::showPose, Qt::QueuedConnection);
    dock_->setOpening(tr("Opening %1…").arg(bagCalled(*robot)));
    clock_->attach(*robot, *session);
    context_.panels.open(dock_);
    // They would take Space for a search.
    for (QAbstractItemView* const list : context_.window.findChildren<QAbstractItemView*>())
      list->installEventFilter(this);
  } else if (was_replay && !std::exchange(dock_was_open_, true)) {
    dock_->hide();
  }
  if (!robot) dock_->setOpening({});
  maps_chosen_ = false;
  fits_track_ = robot != nullptr;
  opened_at_s_.reset();
  if (session && mode_before_ && viewMode(context_.scene) == ViewMode::Whole)
    setViewMode(context_.scene, *mode_before_);
  if (session) mode_before_.reset();
  refresh();
}

void ReplayController::leaveLayout() {
  shown_before_ = dock_->toggleViewAction()->isChecked();
  if (replayOf(context_.current.session()) && !dock_was_open_) dock_->hide();
}

void ReplayController::onLayout() {
  if (!replayOf(context_.current.session())) return;
  dock_was_open_ = dock_->toggleViewAction()->isChecked();
  if (shown_before_) context_.panels.open(dock_);
}

void ReplayController::onConnection() {
  const session::Session* const session = context_.current.session();
  const replay::ReplayRobot* const robot = replayOf(session);
  if (robot && robot->connection().phase == ConnectionPhase::Refused)
    dock_->setOpening(tr("%1 cannot be played: %2")
                          .arg(bagCalled(*robot), sentences::sentenceOf(robot->connection().reason)));
  refresh();
}

void ReplayController::onOpened() {
  clock_->reading()->setWhole(read_all_->isChecked());
  dock_->view()->setFocus();
  refresh();
}

void ReplayController::showPose() {
  if (clock_->isOpen()) context_.scene.setPoseBetween(clock_->poseBetween());
}

void ReplayController::onLink() {
  const replay::Reading* const reading = clock_->reading();
  const bool away = reading && reading->info() && reading->info()->awayAt(clock_->at());
  if (std::exchange(away_, away) != away) refresh();
}

void ReplayController::chooseMaps() {
  session::Session* const session = context_.current.session();
  if (maps_chosen_ || !session || !clock_->isOpen() || clock_->knowledge() != replay::Knowledge::Exact)
    return;
  maps_chosen_ = true;
  opened_at_s_ = clock_->at();
  chooseMode();
  fitAtFirst();
}

void ReplayController::fitAtFirst() {
  if (context_.viewpoint.chosen() || !hasToldNoMap(context_.current.session(), mapsInView(context_.scene)))
    return;
  geometry::WorldRect bounds;
  for (const auto& [from, digest] : clock_->reading()->index().digests()) {
    for (const replay::Digest::Pose& sample : digest.poses) bounds.extend(replay::placeOf(sample).position_m);
  }
  if (bounds.empty()) return;
  // The map arrives during playback: it must not move the view.
  context_.viewpoint.choose();
  context_.viewpoint.fitOnce(bounds.grown(kRoomAroundTrackM));
}

void ReplayController::fitTrack(geometry::WorldRect track) {
  const double at_s = clock_->at();
  fits_track_ = fits_track_ && opened_at_s_.value_or(at_s) == at_s;
  if (!fits_track_ || context_.view.following()) return;
  if (const auto robot = context_.scene.robotPose()) track.extend(Eigen::Vector2d(robot->x_m, robot->y_m));
  context_.viewpoint.choose();
  context_.viewpoint.fitOnce(track.grown(kRoomAroundTrackM));
  fits_track_ = clock_->readShare() < 1;
}

void ReplayController::chooseMode() {
  session::Session* const session = context_.current.session();
  const auto& digests = clock_->reading()->index().digests();
  const bool lists_submaps = std::any_of(digests.begin(), digests.end(), [](const auto& digest) {
    return std::any_of(digest.second.last.begin(), digest.second.last.end(), [](const auto& last) {
      return last.first.first == std::size_t(map::topicIndex<map::SubmapList>());
    });
  });
  const auto mode = viewMode(context_.scene);
  if (lists_submaps || digests.empty() || mode != ViewMode::Submaps || !session->robot().wholeMapSource())
    return;
  mode_before_ = mode;
  setViewMode(context_.scene, ViewMode::Whole);
  context_.overlay.toasts()->add(Mark::Neutral,
                                 tr("This bag contains no submap list: the whole map is shown."));
}

QString ReplayController::backWords() const {
  const QString before = context_.current.addressBefore();
  if (before.isEmpty()) return tr("Close the replay");
  const auto address = context_.addresses.parse(before);
  return address && !address->path.isEmpty() ? tr("Back to the map") : tr("Back to the robot");
}

void ReplayController::refresh() {
  const replay::ReplayRobot* const robot = replayOf(context_.current.session());
  back_->setEnabled(robot != nullptr);
  back_->setText(backWords());
  refreshActions();
  dock_->setBack(robot ? backWords() : QString());
  Notice notice;
  if (robot && clock_->isOpen()) {
    notice.mark = Mark::Busy;
    // Of a file there is none that could be.
    QStringList said{(robot->isLocal() ? tr("Replay of %1, not live.")
                                       : tr("Replay of %1, not live. The robot is not changed."))
                         .arg(bagCalled(*robot))};
    // Nothing may look as if it had been recorded.
    const session::MapSlot& slot = context_.current.session()->wholeMap();
    const bool of_now = slot.cells() && slot.shown().key.kind != map::MapKind::Live && !robot->isLocal();
    if (mapsInView(context_.scene).whole && of_now) said << tr("The map is the robot's current one.");
    if (hasToldNoMap(context_.current.session(), mapsInView(context_.scene)))
      said << tr("The bag contains no map up to this time.");
    const std::optional<robot::BagInfo>& info = clock_->reading()->info();
    if (const robot::BagAway* const away = info ? info->awayAt(clock_->at()) : nullptr)
      said << tr("No connection to the robot since %1: nothing was recorded at this time.")
                  .arg(clockText(away->from_s, 0));
    if (info && info->interrupted)
      said << tr("The recording was interrupted at %1, or is still going on.").arg(clockText(info->end_s, 0));
    if (info && info->repair && info->repair->broke_off_s)
      said << tr("The recording was cut off at %1 and has been repaired.")
                  .arg(clockText(*info->repair->broke_off_s, 0));
    notice.sentence = words::paragraph(said);
    notice.offer = backWords();
    notice.accept = [this] { back(); };
    notice.closable = true;
  }
  context_.notices.set(NoticeRank::Replay, std::move(notice));
}

void ReplayController::clickedOnMap(const Eigen::Vector2d& world_m) {
  const replay::Reading* const reading = clock_->reading();
  const bool seen =
      context_.scene.layerVisible(scene::Layer::Trail) || context_.scene.layerVisible(scene::Layer::Track);
  if (!reading || !seen) return;
  const double near_m = kNearTrackPx * context_.scene.view().scale_m_per_px;
  const double now_s = clock_->at();
  struct Hit {
    double at_s, away_m;
  };
  std::vector<Hit> hits;
  for (const auto& [from, digest] : reading->index().digests()) {
    for (const replay::Digest::Pose& sample : digest.poses) {
      const double away_m = std::hypot(sample.pose.x_m - world_m.x(), sample.pose.y_m - world_m.y());
      if (away_m <= near_m) hits.push_back({sample.stamp_s, away_m});
    }
  }
  if (hits.empty()) return;
  // Of several passes the one nearest in time, and of that the nearest position.
  const auto pass = std::min_element(hits.begin(), hits.end(), [&](const Hit& a, const Hit& b) {
    return std::abs(a.at_s - now_s) < std::abs(b.at_s - now_s);
  });
  const double pass_s = pass->at_s;
  const auto nearest = std::min_element(hits.begin(), hits.end(), [&](const Hit& a, const Hit& b) {
    const bool a_in = std::abs(a.at_s - pass_s) <= kOnePassS, b_in = std::abs(b.at_s - pass_s) <= kOnePassS;
    return a_in != b_in ? a_in : a.away_m < b.away_m;
  });
  clock_->seek(nearest->at_s);
}

void ReplayController::recall(const QSettings& settings) {
  read_all_->setChecked(settings.value(kReadAllKey, true).toBool());
  dock_->setHiddenGroups(settings.value(kHiddenEventsKey).toStringList());
  events_->setFollows(settings.value(kFollowEventsKey, true).toBool());
}

void ReplayController::remember(QSettings& settings) {
  settings.setValue(kReadAllKey, read_all_->isChecked());
  settings.setValue(kHiddenEventsKey, dock_->hiddenGroups());
  settings.setValue(kFollowEventsKey, events_->follows());
}

bool ReplayController::onSpaceKey(QObject& at, QKeyEvent& key) {
  if (key.key() != Qt::Key_Space || key.modifiers() || key.isAutoRepeat() || !clock_->isOpen()) return false;
  if (const auto* const list = qobject_cast<QAbstractItemView*>(&at)) {
    const bool switches = list->currentIndex().flags() & Qt::ItemIsUserCheckable;
    if (switches || list->window() != &context_.window) return false;
  }
  clock_->togglePlaying();
  return true;
}

bool ReplayController::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress && watched != &context_.view &&
      onSpaceKey(*watched, static_cast<QKeyEvent&>(*event)))
    return true;
  // Space with a mouse drag moves the map; Space alone plays.
  if (event->type() == QEvent::MouseButtonPress) space_pressed_ = false;
  if (watched == &context_.view &&
      (event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease)) {
    const auto* const key = static_cast<QKeyEvent*>(event);
    const bool space = key->key() == Qt::Key_Space && !key->isAutoRepeat();
    if (event->type() == QEvent::KeyPress && !key->isAutoRepeat())
      space_pressed_ = space && !key->modifiers();
    if (event->type() == QEvent::KeyRelease && space && std::exchange(space_pressed_, false) &&
        clock_->isOpen())
      clock_->togglePlaying();
  }
  return Controller::eventFilter(watched, event);
}

}  // namespace mapwright::ui

#include "moc_replay_controller.cpp"
