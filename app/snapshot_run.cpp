#include "app/snapshot_run.h"

#include <algorithm>
#include <utility>

#include <QCoreApplication>
#include <QMetaMethod>

#include "app/exit_code.h"
#include "app/report.h"
#include "app/snapshot_content.h"
#include "map/failure.h"
#include "replay/replay_robot.h"
#include "robot/bag_library.h"
#include "sentences/absence_sentence.h"
#include "sentences/failure_sentence.h"
#include "sentences/fault_sentence.h"
#include "sentences/subject_name.h"

namespace mapwright::app {
namespace {

class SnapshotRunText {
  Q_DECLARE_TR_FUNCTIONS(SnapshotRun)
};

constexpr int kSnapshotTries = 3;  // attempts for a submap before it counts as failed
constexpr int kSnapshotConnectAttempts = 3;
constexpr double kConnectWithinS = 10;
constexpr int kSnapshotLookEveryMs = 20;
constexpr double kBagMapWithinS = 0;  // the map of a bag is there with its state, or not at all
constexpr double kNoteEveryS = 0.25;
// If the robot is gone, waiting ends when this much time is left, since drawing takes some, too.
constexpr double kDrawShare = 0.2, kDrawAtMostS = 5;
constexpr double kListWithinS = 8, kListAtLeastS = 3;  // if a whole map can be drawn instead

int milliseconds(double seconds) { return int(std::clamp(seconds * 1000, 0.0, 2e9)); }

}  // namespace

SnapshotRun::SnapshotRun(SnapshotOptions options, std::unique_ptr<robot::Robot> robot, CommandStart start)
    : automatic_(options.mode == SnapshotMode::Automatic),
      options_(decided(std::move(options), *robot)),
      session_(std::move(robot), sessionFor(options_, workers_)),
      map_(session_, options_.map ? QString::fromStdString(map::toText(*options_.map)) : QString(),
           options_.layers.contains(scene::Layer::Waypoints)),
      live_layers_(session_),
      cloud_(session_),
      start_(start) {
  session_.setSlice(options_.slice);
  replayed_ = qobject_cast<replay::ReplayRobot*>(&session_.robot());
  if (replayed_) {
    connect(replayed_, &replay::ReplayRobot::jumped, this,
            [this](const map::World& world, replay::Knowledge knowledge) {
              if (recalled_ || knowledge != replay::Knowledge::Exact) return;
              recalled_ = true;
              session_.reset(world);
              for (const auto& [topic, stamp_s] : replayed_->topics()) live_layers_.hear(topic);
            });
  }
  if (robot::OffersTopics* const of = robot::topicsOfferedBy(session_.robot())) of->choose(options_.topics);
  map_.setPatience(replayed_ ? kBagMapWithinS : options_.timeout_s / 2);
  if (!automatic_) map_.agreeToWhole();
  for (QTimer* timer : {&timeout_, &cut_off_, &settle_}) {
    timer->setSingleShot(true);
    timer->setTimerType(Qt::PreciseTimer);
  }
  connect(&timeout_, &QTimer::timeout, this, &SnapshotRun::timeOut);
  connect(&cut_off_, &QTimer::timeout, this, &SnapshotRun::cutOff);
  connect(&settle_, &QTimer::timeout, this,
          [this] { paint(!wantsSubmaps(options_) || session_.settled(kSnapshotTries)); });
  connect(&poll_, &QTimer::timeout, this, &SnapshotRun::look);
  connect(&session_, &session::Session::connectionChanged, this, &SnapshotRun::look);
  connect(&session_, &session::Session::listChanged, this, [this] {
    if (options_.center_m) return;
    const geometry::WorldRect bounds = session_.contentBounds();
    session_.setView(bounds, bounds.center());
  });
  if (options_.average) session_.wholeMap().setReduction(grids::Reduction::Average);
  connect(&session_.wholeMap(), &session::MapSlot::changed, this, &SnapshotRun::look, Qt::QueuedConnection);
  connect(&session_.wholeMap(), &session::MapSlot::changed, this, [this] {
    const auto grid = wantsWhole(options_) ? map_.grid() : std::nullopt;
    if (first_paint_s_ < 0 && grid && grid->cells->rowsReady() > 0) first_paint_s_ = seconds();
  });
  connect(&session_, &session::Session::submapsPlaced, this, [this] {
    if (first_paint_s_ < 0) first_paint_s_ = seconds();
  });
}

SnapshotRun::~SnapshotRun() = default;

double SnapshotRun::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_.begun).count();
}

void SnapshotRun::start() {
  timeout_.start(milliseconds(options_.timeout_s - seconds()));
  poll_.start(kSnapshotLookEveryMs);
  view_ = viewOf(options_, session_, map_);
  if (options_.center_m) session_.setView(view_.visibleWorld(), view_.center_m);
  noteStanding();
  session_.open();
}

bool SnapshotRun::isLocal() const { return session_.robot().isLocal(); }

QString SnapshotRun::whatOfTheLink() const {
  const robot::ConnectionState link = session_.connection();
  if (link.phase == robot::ConnectionPhase::Online) return {};
  return QLatin1Char(' ') +
         SnapshotRunText::tr("The connection to the robot was lost. %1").arg(sentences::wordsOf(link.reason));
}

QString SnapshotRun::noConnection() const {
  const QString reason = sentences::wordsOf(session_.connection().reason);
  return SnapshotRunText::tr("%1: no connection within %2 s.%3")
      .arg(options_.robot, QString::number(options_.timeout_s),
           reason.isEmpty() ? QString() : QLatin1Char(' ') + reason);
}

bool SnapshotRun::connected() {
  if (connected_s_ >= 0) return true;
  const robot::ConnectionState link = session_.connection();
  if (link.phase == robot::ConnectionPhase::Refused) {
    // An unreadable file is not an unreachable robot.
    const int code = replayed_ ? exitCodeOf(link.failure, kUnreachable) : int(kUnreachable);
    QString subject = options_.robot;
    if (replayed_)
      subject += QStringLiteral(": ") +
                 sentences::nameOf(subjectOf(robot::BagKey{robot::BagKind::Bag, options_.bag}));
    fail(isLocal() ? kUsage : code, QStringLiteral("%1: %2").arg(subject, whyNotConnected(link)));
    return false;
  }
  if (link.phase != robot::ConnectionPhase::Online) {
    const bool gave_up = link.phase == robot::ConnectionPhase::Interrupted &&
                         (link.attempt >= kSnapshotConnectAttempts || seconds() > kConnectWithinS ||
                          link.failure == map::FailureKind::NotARobot);
    if (gave_up) {
      fail(exitCodeOf(link.failure, kUnreachable),
           QStringLiteral("%1: %2").arg(options_.robot, whyNotConnected(link)));
    }
    return false;
  }
  if (replayed_ && !recalled()) return false;
  if (options_.mode == SnapshotMode::Submaps && !session_.robot().submapSource()) {
    const QString why =
        sentences::whyAbsent(robot::Capability::Submaps, session_.robot().whyNot(robot::Capability::Submaps));
    fail(isLocal() ? kUsage : kRobotError, QStringLiteral("%1: %2").arg(options_.robot, why));
    return false;
  }
  if (!topicsChoosable()) return false;
  connected_s_ = seconds();
  live_layers_.ask(options_.layers,
                   wantsWhole(options_) && (!options_.map || options_.map->kind == map::MapKind::Live));
  // A robot is drawn on the maps that it is in, which the catalogue tells.
  asks_where_ = !options_.raw && wantsWhole(options_) && options_.map &&
                options_.map->kind != map::MapKind::Live && session_.robot().liveTopics() &&
                std::any_of(options_.layers.begin(), options_.layers.end(), scene::followsRobot);
  if (asks_where_) session_.catalogue().refresh();
  if (options_.center_m && !options_.region && wantsCloud()) cloud_.ask(view_.visibleWorld());
  if (options_.settle_s) settle_.start(milliseconds(*options_.settle_s));
  return true;
}

bool SnapshotRun::topicsChoosable() {
  robot::OffersTopics* const of = robot::topicsOfferedBy(session_.robot());
  if (options_.topics.empty() || (of && of->chosen() == options_.topics)) return true;
  fail(kUsage, SnapshotRunText::tr("%1: its topics cannot be chosen (--layers NAME=TOPIC): this only works "
                                   "for ROS robots and their recordings.")
                   .arg(options_.robot));
  return false;
}

bool SnapshotRun::drawsScansAlone() const {
  const auto& clouds = session_.live().clouds;
  return automatic_ && !options_.map && !options_.raw && options_.layers.contains(scene::Layer::Cloud) &&
         std::any_of(clouds.begin(), clouds.end(),
                     [](const auto& cloud) { return cloud.second && !cloud.second->empty(); });
}

bool SnapshotRun::recalled() {
  if (!replayed_->at()) {
    replayed_->reading()->setWhole(wantsTrack());
    replayed_->goTo(*options_.at_s);
  }
  const replay::Cell* gap = replayed_->reading()->chunks().gapUntil(*options_.at_s);
  const bool rejected = gap && gap->failure.kind == map::FailureKind::RejectedByRobot;
  const bool final = gap && (gap->tries >= kSnapshotTries || (rejected && !map::mayPass(gap->failure)));
  if (!recalled_ && final) {
    const QString sentence = QString::fromStdString(sentences::sentenceOf(gap->failure));
    fail(exitCodeOf(gap->failure.kind), QStringLiteral("%1: %2").arg(options_.robot, sentence));
  }
  return recalled_;
}

double SnapshotRun::listWithin() const {
  // Data that is not in a bag will not arrive later: no waiting.
  if (replayed_) return -1;

  return std::clamp(options_.timeout_s / 4, kListAtLeastS, kListWithinS);
}

bool SnapshotRun::wantsWholeInstead() {
  robot::Robot& robot = session_.robot();
  const bool for_submaps = options_.slice != 0 || options_.colors != render::ColorMode::Normal ||
                           options_.layers.contains(scene::Layer::Submaps);
  const bool listed = replayed_ ? session_.world().submaps.has_value() : session_.submaps().listReceived();
  return automatic_ && options_.mode == SnapshotMode::Submaps && !for_submaps && !listed &&
         seconds() - connected_s_ > listWithin() && robot.wholeMapSource() != nullptr;
}

void SnapshotRun::takeWholeInstead() {
  options_.mode = SnapshotMode::Whole;
  whole_asked_s_ = seconds() - connected_s_;
  shown_instead_ = SnapshotRunText::tr(
                       "The robot sent no submap list within %1 s: its whole map is drawn instead. Pass "
                       "--mode submaps to wait longer.")
                       .arg(listWithin());
  if (replayed_)
    shown_instead_ =
        SnapshotRunText::tr("The bag contains no submap list up to this time: a whole map is drawn instead.");
  notes_ << shown_instead_;
  live_layers_.ask(options_.layers, true);
}

void SnapshotRun::look() {
  if (done_ || chosen_ || !connected()) return;
  if (options_.region) return lookAtRegion();
  if (wantsWholeInstead()) takeWholeInstead();
  // Do not wait for pictures that a bag names but the robot no longer has.
  const bool coming = replayed_ && replayed_->picturesUnderWay() > 0;
  const double waited_s = coming ? 0 : seconds() - connected_s_ - whole_asked_s_;
  if (wantsWhole(options_) && !scans_alone_ && map_.look(waited_s) == MapWish::State::Failed) {
    if (!drawsScansAlone()) {
      fail(map_.failure().exit_code, QStringLiteral("%1: %2").arg(options_.robot, map_.failure().sentence));
      return;
    }
    scans_alone_ = true;
    notes_ << SnapshotRunText::tr("%1 The robot's sensor data is drawn without a map.")
                  .arg(map_.failure().sentence);
  }
  if (!options_.settle_s && everythingIn() && topicsIn() && cloudIn()) {
    paint(true);
  } else if (goneForGood() && somethingIn()) {
    notes_ << SnapshotRunText::tr("Not everything had arrived.") + whatOfTheLink();
    paint(false);
  } else if (seconds() - noted_s_ > std::max(kNoteEveryS, 20 * note_took_s_)) {
    // Counting a hundred thousand submaps takes a moment, so do not do it every time.
    noteStanding();
    tellProgress();
  }
}

void SnapshotRun::tellProgress() {
  if (!isSignalConnected(QMetaMethod::fromSignal(&SnapshotRun::progressed))) return;
  if (wantsWhole(options_)) {
    const session::MapSlot& slot = session_.wholeMap();
    Q_EMIT progressed(SnapshotRunText::tr("Map %1: %2 % read")
                          .arg(slot.name(), QString::number(int(slot.progress() * 100))));
  }
  if (wantsSubmaps(options_)) {
    const QJsonObject submaps = board_->take().report[QLatin1String("submaps")].toObject();
    const auto count = [&](const char* what) { return submaps[QLatin1String(what)].toInt(); };
    Q_EMIT progressed(SnapshotRunText::tr("%1 of %2 submaps, %3 missing, %4 corrupt")
                          .arg(count("drawn"))
                          .arg(count("listed"))
                          .arg(count("missing"))
                          .arg(count("corrupt")));
  }
}

void SnapshotRun::noteStanding() {
  const double began_s = seconds();
  SnapshotStanding standing;
  const bool connected = connected_s_ >= 0;
  standing.exit_code = connected ? kIncomplete : kUnreachable;
  standing.sentence =
      connected ? SnapshotRunText::tr("Incomplete: no picture could be made within %1 s (--timeout).")
                      .arg(options_.timeout_s)
                : noConnection();
  if (connected) standing.sentence += whatOfTheLink();
  standing.report = report();
  standing.report[QStringLiteral("complete")] = false;
  QJsonArray warnings = standing.report[QLatin1String("warnings")].toArray();
  warnings.prepend(standing.sentence);
  standing.report[QStringLiteral("warnings")] = warnings;
  board_->put(std::move(standing));
  noted_s_ = seconds();
  note_took_s_ = noted_s_ - began_s;
}

bool SnapshotRun::wantsTrack() const {
  return replayed_ && !options_.raw && options_.layers.contains(scene::Layer::Track);
}

bool SnapshotRun::topicsIn() const {
  if (replayed_)
    return !session_.layerGrids().busy() && replayed_->picturesUnderWay() == 0 &&
           (!wantsTrack() || replayed_->reading()->chunks().wholeRead());
  return live_layers_.in() || seconds() - connected_s_ > kTopicsWithinS;
}

bool SnapshotRun::lacksSubmaps() const {
  return replayed_ && recalled_ && wantsSubmaps(options_) && !session_.world().submaps;
}

bool SnapshotRun::everythingIn() const {
  if (wantsSubmaps(options_) && !lacksSubmaps() && !session_.settled(kSnapshotTries)) return false;
  if (asks_where_ && session_.catalogue().loading() && seconds() - connected_s_ < kTopicsWithinS)
    return false;
  if (!wantsWhole(options_) || scans_alone_) return true;
  const bool points_in =
      !options_.layers.contains(scene::Layer::Waypoints) || !session_.wholeMap().waypointsAwaited();
  return map_.grid() && session_.wholeMap().settled() && points_in;
}

bool SnapshotRun::wantsCloud() const {
  return !replayed_ && !options_.raw && options_.layers.contains(scene::Layer::DispatchedCloud);
}

bool SnapshotRun::cloudIn() {
  if (!wantsCloud()) return true;
  cloud_.ask(options_.region ? *options_.region : viewOf(options_, session_, map_).visibleWorld());
  return cloud_.in();
}

bool SnapshotRun::goneForGood() const {
  if (options_.settle_s || session_.connection().phase == robot::ConnectionPhase::Online) return false;
  return options_.timeout_s - seconds() < std::min(kDrawShare * options_.timeout_s, kDrawAtMostS);
}

bool SnapshotRun::somethingIn() const {
  return wantsWhole(options_) ? map_.grid().has_value() : session_.counts().texture_bytes > 0;
}

void SnapshotRun::timeOut() {
  if (done_) return;
  if (connected_s_ < 0) {
    fail(kUnreachable, noConnection());
    return;
  }
  // Draws what has arrived, if that only takes a moment.
  cut_off_.start(milliseconds(options_.timeout_s + start_.grace.draw_s - seconds()));
  if (chosen_) return;
  const bool no_list = wantsSubmaps(options_) && !session_.submaps().listReceived();
  notes_ << (!no_list ? SnapshotRunText::tr("Not everything had arrived within %1 s (--timeout).")
                                .arg(options_.timeout_s) +
                            whatOfTheLink()
                      : SnapshotRunText::tr("The robot sent no submap list within %1 s (--timeout). Pass "
                                            "--mode whole to draw its whole map.")
                                .arg(options_.timeout_s) +
                            whatOfTheLink());
  paint(false);
}

void SnapshotRun::cutOff() {
  if (done_) return;
  complete_ = false;
  notes_.prepend(
      SnapshotRunText::tr("The picture was not finished within %1 s (--timeout): parts of it are empty.")
          .arg(options_.timeout_s));
  write();
}

void SnapshotRun::fail(int exit_code, const QString& sentence) {
  error_ = sentence;
  complete_ = false;
  finish(exit_code);
}

void SnapshotRun::finish(int exit_code) {
  if (done_) return;
  done_ = true;
  for (QTimer* timer : {&poll_, &timeout_, &cut_off_, &settle_}) timer->stop();
  complete_s_ = seconds();
  Q_EMIT finished(exit_code);
}

}  // namespace mapwright::app

#include "moc_snapshot_run.cpp"
