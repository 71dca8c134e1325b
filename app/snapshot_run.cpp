#include "app/snapshot_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QCoreApplication>
#include <QJsonArray>
#include <QMetaMethod>

#include "app/exit_code.h"
#include "app/fetch_ahead.h"
#include "app/output_paths.h"
#include "app/report.h"
#include "app/robot_factory.h"
#include "robot/address.h"
#include "scene/write_picture.h"
#include "sentences/reason_sentence.h"

namespace mapwright::app {
namespace {

class Words {
  Q_DECLARE_TR_FUNCTIONS(SnapshotRun)
};

constexpr double kFitMarginPx = 16;
constexpr int kTries = 3;  // of a failing submap, before it counts as failed
constexpr int kConnectAttempts = 3;
constexpr double kConnectWithinS = 10;
constexpr int kLookEveryMs = 20;
constexpr double kTopicsWithinS = 3;  // live layers, after connecting
constexpr double kNoteEveryS = 0.25;
// Of a robot that is gone nothing more is waited for when so much of the time is left: drawing takes some,
// too.
constexpr double kDrawShare = 0.2, kDrawAtMostS = 5;
constexpr double kListWithinS = 8, kListAtLeastS = 3;  // where a whole map can be drawn instead

bool wantsSubmapsOf(const SnapshotOptions& options) {
  return options.mode == SnapshotMode::Submaps || options.layers.contains(scene::Layer::Submaps);
}

SnapshotOptions decided(SnapshotOptions options, robot::Robot& robot) {
  if (options.mode == SnapshotMode::Automatic) {
    options.mode = robot.submapSource() ? SnapshotMode::Submaps : SnapshotMode::Whole;
  }
  return options;
}

/// Only what is drawn is asked for.
session::Session::Options sessionOptions(const SnapshotOptions& options,
                                         const std::shared_ptr<work::Workers>& workers) {
  session::Session::Options session;
  session.workers = workers;
  session.scheduler.max_concurrent = kFetchAhead;
  session.sidecar_folder = gridCacheFolder();
  session.overview = false;  // a picture shows what is exact, or nothing
  session.maps = false;
  session.basics = LayerWish::basics(options.layers, wantsSubmapsOf(options));
  return session;
}

int milliseconds(double seconds) { return int(std::clamp(seconds * 1000, 0.0, 2e9)); }

}  // namespace

/// What the picture is made of, and what is said of it.
struct SnapshotChoice {
  session::SubmapCounts counts;
  QStringList problems;
  std::optional<QJsonObject> map;
  bool refused = false;  // something was: not without (the right) secret
};

void SnapshotRun::StandingBoard::put(Standing standing) {
  const std::lock_guard lock(mutex_);
  standing_ = std::move(standing);
}

SnapshotRun::Standing SnapshotRun::StandingBoard::take() const {
  const std::lock_guard lock(mutex_);
  return standing_;
}

SnapshotRun::SnapshotRun(SnapshotOptions options, std::unique_ptr<robot::Robot> robot, CommandStart start)
    : automatic_(options.mode == SnapshotMode::Automatic),
      options_(decided(std::move(options), *robot)),
      session_(std::move(robot), sessionOptions(options_, workers_)),
      map_(session_, options_.map ? QString::fromStdString(map::toText(*options_.map)) : QString(),
           options_.layers.contains(scene::Layer::Waypoints)),
      live_layers_(session_),
      start_(start) {
  session_.setSlice(options_.slice);
  map_.setPatience(options_.timeout_s / 2);
  for (QTimer* timer : {&timeout_, &cut_off_, &settle_}) {
    timer->setSingleShot(true);
    timer->setTimerType(Qt::PreciseTimer);
  }
  connect(&timeout_, &QTimer::timeout, this, &SnapshotRun::timeOut);
  connect(&cut_off_, &QTimer::timeout, this, &SnapshotRun::cutOff);
  connect(&settle_, &QTimer::timeout, this, [this] { paint(session_.settled(kTries)); });
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
    const auto grid = wantsWhole() ? map_.grid() : std::nullopt;
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
  poll_.start(kLookEveryMs);
  view_ = chooseView();
  if (options_.center_m) session_.setView(view_.visibleWorld(), view_.center_m);
  noteStanding();
  session_.open();
}

bool SnapshotRun::isLocal() const { return session_.robot().isLocal(); }

bool SnapshotRun::wantsSubmaps() const { return wantsSubmapsOf(options_); }

bool SnapshotRun::wantsWhole() const {
  return options_.mode == SnapshotMode::Whole || options_.layers.contains(scene::Layer::WholeMap);
}

geometry::ViewTransform SnapshotRun::chooseView() const {
  geometry::ViewTransform view;
  view.width_px = options_.size_px.width();
  view.height_px = options_.size_px.height();
  view.rotation_rad = options_.rotation_rad;
  if (!options_.center_m) {
    geometry::WorldRect bounds;
    if (wantsSubmaps()) bounds.extend(session_.contentBounds());
    const auto grid = wantsWhole() ? map_.grid() : std::nullopt;
    if (grid) bounds.extend(grid->reference.bounds());
    return view.fitted(bounds, kFitMarginPx);
  }
  view.center_m = *options_.center_m;
  view.scale_m_per_px = options_.scale_m_per_px;
  return view;
}

QString SnapshotRun::whatOfTheLink() const {
  const robot::ConnectionState link = session_.connection();
  if (link.phase == robot::ConnectionPhase::Online) return {};
  return QLatin1Char(' ') +
         Words::tr("The connection to the robot was lost. %1").arg(sentences::wordsOf(link.reason));
}

QString SnapshotRun::noConnection() const {
  const QString reason = sentences::wordsOf(session_.connection().reason);
  return Words::tr("%1: no connection within %2 s.%3")
      .arg(options_.robot, QString::number(options_.timeout_s),
           reason.isEmpty() ? QString() : QLatin1Char(' ') + reason);
}

bool SnapshotRun::connected() {
  if (connected_s_ >= 0) return true;
  const robot::ConnectionState link = session_.connection();
  if (link.phase == robot::ConnectionPhase::Refused) {
    // A file that cannot be read is no robot that cannot be reached.
    fail(isLocal() ? kUsage : kUnreachable,
         QStringLiteral("%1: %2").arg(options_.robot, whyNotConnected(link)));
    return false;
  }
  if (link.phase != robot::ConnectionPhase::Online) {
    const bool gave_up = link.phase == robot::ConnectionPhase::Interrupted &&
                         (link.attempt >= kConnectAttempts || seconds() > kConnectWithinS ||
                          link.failure == map::FailureKind::NotARobot);
    if (gave_up) {
      fail(exitCodeOf(link.failure, kUnreachable),
           QStringLiteral("%1: %2").arg(options_.robot, whyNotConnected(link)));
    }
    return false;
  }
  connected_s_ = seconds();
  live_layers_.ask(options_.layers,
                   wantsWhole() && (!options_.map || options_.map->kind == map::MapKind::Live));
  // A robot is drawn on the maps that it is in: which one that is, its list of maps tells.
  asks_where_ = !options_.raw && wantsWhole() && options_.map && options_.map->kind != map::MapKind::Live &&
                session_.robot().liveTopics() &&
                std::any_of(options_.layers.begin(), options_.layers.end(), scene::followsRobot);
  if (asks_where_) session_.catalogue().refresh();
  if (options_.settle_s) settle_.start(milliseconds(*options_.settle_s));
  return true;
}

double SnapshotRun::listWithin() const {
  return std::clamp(options_.timeout_s / 4, kListAtLeastS, kListWithinS);
}

bool SnapshotRun::wantsWholeInstead() {
  robot::Robot& robot = session_.robot();
  const bool for_submaps = options_.slice != 0 || options_.colors != render::ColorMode::Normal ||
                           options_.layers.contains(scene::Layer::Submaps);
  return automatic_ && options_.mode == SnapshotMode::Submaps && !for_submaps &&
         !session_.book().listReceived() && seconds() - connected_s_ > listWithin() &&
         robot.wholeMapSource() != nullptr;
}

void SnapshotRun::takeWholeInstead() {
  options_.mode = SnapshotMode::Whole;
  whole_asked_s_ = seconds() - connected_s_;
  shown_instead_ =
      Words::tr(
          "The robot sent no submap list within %1 s: its whole map is drawn instead. --mode submaps waits "
          "longer.")
          .arg(listWithin());
  notes_ << shown_instead_;
  live_layers_.ask(options_.layers, true);
}

void SnapshotRun::look() {
  if (done_ || chosen_ || !connected()) return;
  if (wantsWholeInstead()) takeWholeInstead();
  if (wantsWhole() && map_.look(seconds() - connected_s_ - whole_asked_s_) == MapWish::State::Failed) {
    fail(map_.failure().exit_code, QStringLiteral("%1: %2").arg(options_.robot, map_.failure().sentence));
    return;
  }
  if (!options_.settle_s && everythingIn() && topicsIn()) {
    paint(true);
  } else if (goneForGood() && somethingIn()) {
    notes_ << Words::tr("Not everything had arrived.") + whatOfTheLink();
    paint(false);
  } else if (seconds() - noted_s_ > std::max(kNoteEveryS, 20 * note_took_s_)) {
    // Counting a hundred thousand submaps takes a moment: that may not be all that is done.
    noteStanding();
    tellProgress();
  }
}

void SnapshotRun::tellProgress() {
  if (!isSignalConnected(QMetaMethod::fromSignal(&SnapshotRun::progressed))) return;
  if (wantsWhole()) {
    const session::MapSlot& slot = session_.wholeMap();
    Q_EMIT progressed(Words::tr("Map %1: %2 % read").arg(slot.name()).arg(int(slot.progress() * 100)));
  }
  if (wantsSubmaps()) {
    const QJsonObject submaps = board_->take().report[QLatin1String("submaps")].toObject();
    const auto count = [&](const char* what) { return submaps[QLatin1String(what)].toInt(); };
    Q_EMIT progressed(Words::tr("%1 of %2 submaps, %3 missing, %4 corrupt")
                          .arg(count("drawn"))
                          .arg(count("listed"))
                          .arg(count("missing"))
                          .arg(count("corrupt")));
  }
}

void SnapshotRun::noteStanding() {
  const double began_s = seconds();
  Standing standing;
  const bool connected = connected_s_ >= 0;
  standing.exit_code = connected ? kIncomplete : kUnreachable;
  standing.sentence = connected ? Words::tr("Not complete. No picture could be made within %1 s (--timeout).")
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

bool SnapshotRun::topicsIn() const { return live_layers_.in() || seconds() - connected_s_ > kTopicsWithinS; }

bool SnapshotRun::everythingIn() const {
  if (wantsSubmaps() && !session_.settled(kTries)) return false;
  if (asks_where_ && session_.catalogue().loading() && seconds() - connected_s_ < kTopicsWithinS)
    return false;
  if (!wantsWhole()) return true;
  const bool points_in =
      !options_.layers.contains(scene::Layer::Waypoints) || !session_.wholeMap().waypointsAwaited();
  return map_.grid() && session_.wholeMap().settled() && points_in;
}

bool SnapshotRun::goneForGood() const {
  if (options_.settle_s || session_.connection().phase == robot::ConnectionPhase::Online) return false;
  return options_.timeout_s - seconds() < std::min(kDrawShare * options_.timeout_s, kDrawAtMostS);
}

bool SnapshotRun::somethingIn() const {
  return wantsWhole() ? map_.grid().has_value() : session_.counts().texture_bytes > 0;
}

void SnapshotRun::timeOut() {
  if (done_) return;
  if (connected_s_ < 0) {
    fail(kUnreachable, noConnection());
    return;
  }
  // What has come is drawn, as far as that takes no longer than a moment.
  cut_off_.start(milliseconds(options_.timeout_s + start_.grace.draw_s - seconds()));
  if (chosen_) return;
  const bool no_list = wantsSubmaps() && !session_.book().listReceived();
  notes_ << (!no_list
                 ? Words::tr("Not everything had arrived within %1 s (--timeout).").arg(options_.timeout_s) +
                       whatOfTheLink()
                 : Words::tr(
                       "The robot sent no submap list within %1 s (--timeout). Its whole map is drawn by "
                       "--mode whole.")
                           .arg(options_.timeout_s) +
                       whatOfTheLink());
  paint(false);
}

void SnapshotRun::cutOff() {
  if (done_) return;
  complete_ = false;
  notes_.prepend(Words::tr("The picture was not finished within %1 s (--timeout): parts of it are empty.")
                     .arg(options_.timeout_s));
  write();
}

bool SnapshotRun::waypointsLost() const {
  if (options_.raw || !wantsWhole() || !options_.layers.contains(scene::Layer::Waypoints)) return false;
  const auto& rows = session_.problems().rows();
  return std::any_of(rows.begin(), rows.end(), [](const session::LoggedProblem& row) {
    return !row.resolved && row.problem.subject.kind == map::SubjectKind::Places &&
           row.problem.code == map::ProblemCode::Unavailable;
  });
}

SnapshotContent SnapshotRun::chooseContent() const {
  SnapshotContent content;
  content.view = view_;
  content.submaps = wantsSubmaps();
  content.whole = options_.raw ? options_.mode == SnapshotMode::Whole : wantsWhole() && map_.grid();
  if (!options_.raw) return content;
  if (content.whole) {
    content.grid = map_.grid();
    return content;
  }
  for (const auto& [id, row] : session_.book().rows()) {
    if (const auto placement = session_.book().placement(id, options_.slice)) {
      content.textures.push_back({id, placement->texture, placement->world_from_texture, 0});
    }
  }
  return content;
}

void SnapshotRun::paint(bool settled) {
  if (done_ || chosen_) return;
  if (options_.mode == SnapshotMode::Whole && !map_.grid()) {
    const QString which = options_.map
                              ? Words::tr("map %1").arg(QString::fromStdString(map::toText(*options_.map)))
                              : Words::tr("its map");
    fail(exitCodeOf(map::FailureKind::TimedOut),
         Words::tr("%1: %2 had not arrived within %3 s (%4). There is nothing to draw.")
                 .arg(options_.robot, which, QString::number(options_.settle_s.value_or(options_.timeout_s)),
                      options_.settle_s ? QStringLiteral("--settle") : QStringLiteral("--timeout")) +
             whatOfTheLink());
    return;
  }
  poll_.stop();
  settle_.stop();
  // The picture takes a while to be made. What the robot sends meanwhile must change neither it nor what is
  // said of it.
  session_.standStill();
  session_.close();
  chosen_ = std::make_unique<SnapshotChoice>();
  chosen_->counts = session_.counts();
  chosen_->problems = problemLines(session_.problems());
  chosen_->refused = anyRefused(session_.problems());
  if (const auto grid = wantsWhole() ? map_.grid() : std::nullopt) {
    chosen_->map = mapJson(*map_.key(), session_.wholeMap().name(), grid->reference);
  }
  complete_ = settled && (!wantsSubmaps() || submapsComplete(chosen_->counts)) &&
              (!wantsWhole() || map_.complete()) && !waypointsLost();
  for (const QString& topic : live_layers_.silent()) {
    notes_ << Words::tr("Topic %1 gave nothing within %2 s.")
                  .arg(topic, QString::number(options_.settle_s.value_or(kTopicsWithinS)));
  }
  const session::SubmapCounts& counts = chosen_->counts;
  if (counts.without_slice > 0 && counts.without_slice == counts.listed) {
    notes_ << Words::tr("No submap has a slice %1 (--slice): the picture is empty.").arg(options_.slice);
  }
  view_ = chooseView();
  noteStanding();
  Q_EMIT contentChosen();
  const SnapshotContent content = chooseContent();
  picture_ = options_.raw ? makeRawPicture(content, workers_)
                          : makeScenePicture(options_, session_, content, workers_);
  connect(picture_.get(), &SnapshotPicture::finished, this, &SnapshotRun::write);
  picture_->start();
  notes_ += picture_->notes();
}

void SnapshotRun::write() {
  if (done_) return;
  made_ = picture_->made();
  if (const auto grid = wantsWhole() ? map_.grid() : std::nullopt; grid && grid->cells->trouble().any()) {
    complete_ = false;
    notes_.prepend(sentences::wordsOf(grid->cells->trouble()));
  }
  if (session_.lostPictures() > 0) {
    complete_ = false;
    notes_.prepend(
        Words::tr("%1 submaps could not be read back from the disk: parts of the picture are empty.", nullptr,
                  int(session_.lostPictures()))
            .arg(session_.lostPictures()));
  }
  if (const auto why = overItsSource()) {
    fail(kUsage, *why);
  } else if (const auto error = picture_->write(options_.output)) {
    fail(kUsage, *error);
  } else {
    finish(complete_ ? kDone : chosen_->refused ? exitCodeOf(map::FailureKind::Refused) : kIncomplete);
  }
}

std::optional<QString> SnapshotRun::overItsSource() const {
  if (options_.force) return std::nullopt;
  const session::MapSlot& slot = session_.wholeMap();
  return overOwnSource({options_.output, options_.report},
                       sourceFilesOf(options_.robot, slot.key().id, slot.shown().path));
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

QStringList SnapshotRun::warnings() const {
  QStringList all;
  if (!error_.isEmpty()) all << error_;
  all += chosen_ ? chosen_->problems : problemLines(session_.problems());
  return all + map_.notes() + notes_;
}

QJsonObject SnapshotRun::report() const {
  const session::SubmapCounts counts = chosen_ ? chosen_->counts : session_.counts();
  const auto secondsOrNull = [](double value) {
    return value < 0 ? QJsonValue() : QJsonValue(std::round(value * 1000) / 1000);
  };
  QJsonObject report{
      {QStringLiteral("complete"), complete_},
      {QStringLiteral("mode"),
       options_.mode == SnapshotMode::Whole ? QStringLiteral("whole") : QStringLiteral("submaps")},
      {QStringLiteral("uuid"), QString::fromStdString(session_.book().uuid())},
      {QStringLiteral("submaps"), submapsJson(counts)},
      {QStringLiteral("painted"), std::round(made_ * 1000) / 1000},
      {QStringLiteral("seconds"), QJsonObject{{QStringLiteral("connect"), secondsOrNull(connected_s_)},
                                              {QStringLiteral("first_paint"), secondsOrNull(first_paint_s_)},
                                              {QStringLiteral("complete"), secondsOrNull(complete_s_)}}},
      {QStringLiteral("view"),
       QJsonObject{{QStringLiteral("center"), QJsonArray{view_.center_m.x(), view_.center_m.y()}},
                   {QStringLiteral("scale"), view_.scale_m_per_px},
                   {QStringLiteral("size"), QJsonArray{view_.width_px, view_.height_px}},
                   {QStringLiteral("rotation_deg"), geometry::degreesFromRadians(view_.rotation_rad)}}},
      {QStringLiteral("peak_rss_bytes"), peakMemoryBytes()},
      {QStringLiteral("warnings"), QJsonArray::fromStringList(warnings())},
  };
  const QJsonObject traffic = trafficJson(counts);
  for (auto it = traffic.begin(); it != traffic.end(); ++it) report[it.key()] = it.value();
  if (chosen_ && chosen_->map) report[QStringLiteral("map")] = *chosen_->map;
  return report;
}

}  // namespace mapwright::app
