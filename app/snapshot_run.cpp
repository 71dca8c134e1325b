#include "app/snapshot_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QJsonArray>
#include <QMetaMethod>

#include "app/command_text.h"
#include "app/output.h"
#include "app/report.h"
#include "app/robot_factory.h"
#include "geometry/pose.h"
#include "incident/report.h"
#include "map/failure.h"
#include "replay/replay_robot.h"
#include "robot/bag_library.h"
#include "robot/faults.h"
#include "robot/map_dispatch.h"
#include "sentences/absence_sentence.h"
#include "sentences/failure_sentence.h"
#include "sentences/fault_sentence.h"
#include "sentences/subject_name.h"
#include "session/layer_grids.h"
#include "session/session_options.h"
#include "session/submaps_complete.h"
#include "submap/submap_store.h"
#include "ui/view/track_of_bag.h"
#include "words/listed.h"

namespace mapwright::app {
namespace {

constexpr int kSnapshotTries = 3;  // attempts for a submap before it counts as failed
constexpr int kSnapshotConnectAttempts = 3;
constexpr double kConnectWithinS = 10;
constexpr int kSnapshotLookEveryMs = 20;
constexpr double kTopicsWithinS = 3;   // live layers, after connecting
constexpr double kOffersWithinS = 12;  // regions, after connecting: a slow robot is asked twice
constexpr double kPixelsDrawnInASecond = 2e6, kMostOfTimeToDraw = 0.4;
constexpr double kFitMarginPx = 16;
constexpr double kTallM = 2000;       // higher and deeper than any building
constexpr double kBagMapWithinS = 0;  // the map of a bag is there with its state, or not at all
constexpr double kNoteEveryS = 0.25;
constexpr double kListWithinS = 8, kListAtLeastS = 3;  // if a whole map can be drawn instead

using ui::shot::Awaited;
using ui::shot::EndOfWaiting;
using ui::shot::Lack;
using ui::shot::Stage;

/// Chooses the mode if the user has not, depending on what `robot` offers.
SnapshotOptions decided(SnapshotOptions options, robot::Robot& robot) {
  if (options.mode == SnapshotMode::Automatic)
    options.mode = robot.submapSource() ? SnapshotMode::Submaps : SnapshotMode::Whole;
  return options;
}

/// A session that only requests what is drawn.
session::Session::Options sessionFor(const SnapshotOptions& options,
                                     const std::shared_ptr<work::Workers>& workers) {
  session::Session::Options session = sessionOptions();
  session.workers = workers;
  session.overview = session.maps = false;  // a picture shows exact data, or none
  session.basics = ui::shot::LayerSubscription::basics(
      options.layers, options.wantsSubmaps() || options.quality.disagreement_over.has_value());
  return session;
}

double toThousandths(double value) { return std::round(value * 1000) / 1000; }

/// Whole seconds, or tenths of the first one.
QString passed(double since_s) {
  since_s += 0.05;  // timers may be early
  return QString::number(since_s < 1 ? std::floor(since_s * 10) / 10 : std::floor(since_s));
}

QJsonValue secondsOrNull(std::optional<double> value) {
  return value ? QJsonValue(toThousandths(*value)) : QJsonValue();
}

/// What is to be said about the robot in the picture.
QStringList robotNotes(const ui::scene::MapScene& scene, const session::Session& session) {
  QStringList of_robot;
  for (const ui::scene::Layer layer : ui::scene::allLayers()) {
    if (scene.layerVisible(layer) && ui::scene::specOf(layer).follows_robot)
      of_robot << ui::scene::layerName(layer);
  }
  if (of_robot.isEmpty() || !scene.session()->robot().liveTopics()) return {};
  const ui::scene::RobotPlace& place = scene.robotPlace();
  const QString names = words::listed(of_robot);
  if (place.drawn == ui::scene::ScreenPart::None)
    return {
        Text::tr("The robot is not in this map. Left out: %1. Pass --robot-anyway to draw them.").arg(names)};
  if (place.by_choice) return {Text::tr("The robot is not in this map. Drawn anyway: %1.").arg(names)};
  if (place.where == map::Whereabouts::Unknown && session.live().robot_pose)
    return {Text::tr("The robot does not report which map it is in. It may not be this one: %1.").arg(names)};
  return {};
}

}  // namespace

SnapshotRun::SnapshotRun(SnapshotOptions options, std::unique_ptr<robot::Robot> robot, CommandStart start,
                         std::shared_ptr<work::Workers> workers)
    : automatic_(options.mode == SnapshotMode::Automatic),
      options_(decided(std::move(options), *robot)),
      workers_(std::move(workers)),
      session_(std::move(robot), sessionFor(options_, workers_)),
      map_(session_, options_.map ? QString::fromStdString(map::toText(*options_.map)) : QString(),
           options_.layers.contains(ui::scene::Layer::Waypoints)),
      live_layers_(session_),
      start_(start),
      shot_({options_.timeout_s, options_.settle_s, start.grace.draw_s}) {
  if (options_.region) region_.emplace(options_.robot, *options_.region, options_.scale_m_per_px);
  session_.setSlice(options_.slice);
  replayed_ = qobject_cast<replay::ReplayRobot*>(&session_.robot());
  if (replayed_) recall_.emplace(session_, *replayed_);
  if (robot::OffersTopics* const of = robot::topicsOfferedBy(session_.robot())) of->choose(options_.topics);
  map_.setLiveTimeout(replayed_ ? kBagMapWithinS : options_.timeout_s / 2);
  if (!automatic_) map_.agreeToWhole();
  timer_.setSingleShot(true);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &SnapshotRun::lookAndWait);
  connect(&session_, &session::Session::connectionChanged, this, &SnapshotRun::look);
  connect(&session_, &session::Session::listChanged, this, [this] {
    if (options_.center_m) return;
    const geometry::WorldRect bounds = session_.contentBounds();
    session_.setView(bounds, bounds.center());
  });
  if (options_.average) session_.wholeMap().setAveraged(true);
  connect(&session_.wholeMap(), &session::MapSlot::changed, this, &SnapshotRun::look, Qt::QueuedConnection);
  connect(&session_.wholeMap(), &session::MapSlot::changed, this, [this] {
    const auto grid = wholeGrid();
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
  view_ = chooseView();
  if (options_.center_m) session_.setView(view_.visibleWorld(), view_.center_m);
  updateStanding();
  session_.open();
  lookAndWait();
}

void SnapshotRun::lookAndWait() {
  look();
  if (shot_.over()) return;
  const double limit_ms = std::ceil(shot_.untilLimit(seconds()).value_or(0) * 1000);
  timer_.start(
      int(shot_.waits() ? std::min<double>(kSnapshotLookEveryMs, limit_ms) : std::min(limit_ms, 2e9)));
}

QString SnapshotRun::whatOfTheLink() const {
  const robot::ConnectionState link = session_.connection();
  if (link.phase == robot::ConnectionPhase::Online) return {};
  return Text::tr("The connection to the robot was lost. %1").arg(sentences::wordsOf(link.reason));
}

QString SnapshotRun::noConnection() const {
  const QString reason = sentences::wordsOf(session_.connection().reason);
  return words::paragraph(
      {Text::tr("%1: no connection within %2 s.").arg(options_.robot, QString::number(options_.timeout_s)),
       reason});
}

bool SnapshotRun::connected() {
  if (shot_.connected()) return true;
  const robot::ConnectionState link = session_.connection();
  if (link.phase == robot::ConnectionPhase::Refused) {
    // An unreadable file is not an unreachable robot.
    const int code = replayed_ ? exitCodeOf(link.failure, kUnreachable) : int(kUnreachable);
    QString subject = options_.robot;
    if (replayed_)
      subject += QStringLiteral(": ") +
                 sentences::nameOf(subjectOf(robot::BagKey{robot::BagKind::Bag, options_.bag}));
    fail(isLocal() ? kUsage : code, words::about(subject, notConnectedReason(link)));
    return false;
  }
  if (link.phase != robot::ConnectionPhase::Online) {
    const bool gave_up = link.phase == robot::ConnectionPhase::Interrupted &&
                         (link.attempt >= kSnapshotConnectAttempts || seconds() > kConnectWithinS ||
                          link.failure == map::FailureKind::NotARobot);
    if (gave_up) {
      fail(exitCodeOf(link.failure, kUnreachable), words::about(options_.robot, notConnectedReason(link)));
    }
    return false;
  }
  if (replayed_ && !recalled()) return false;
  if (options_.mode == SnapshotMode::Submaps && !session_.robot().submapSource()) {
    const QString why = sentences::absenceReason(
        robot::Capability::Submaps, session_.robot().unavailableReason(robot::Capability::Submaps));
    fail(isLocal() ? kUsage : kRobotError, words::about(options_.robot, why));
    return false;
  }
  // An option that the picture could not show.
  if (automatic_ && options_.mode == SnapshotMode::Whole && !session_.robot().submapSource() &&
      (options_.slice != 0 || options_.colors != render::ColorMode::Normal)) {
    fail(kUsage,
         Text::tr("%1 has no submaps: --slice and --colors only apply to those.").arg(options_.robot));
    return false;
  }
  if (!topicsChoosable()) return false;
  shot_.enter(Stage::Settling, seconds());
  live_layers_.ask(options_.layers,
                   options_.wantsWhole() && (!options_.map || options_.map->kind == map::MapKind::Live));
  awaitContent();
  if (shot_.awaits(Awaited::Whereabouts)) session_.catalogue().refresh();
  if (options_.center_m && !region_ && wantsCloud()) askForCloud(view_.visibleWorld());
  return true;
}

void SnapshotRun::awaitContent() {
  shot_.forgetAll();
  if (region_) shot_.await(Awaited::Region, [this] { return region_->over(); });
  if (needsSubmaps())
    shot_.await(Awaited::Submaps, [this] { return lacksSubmaps() || session_.settled(kSnapshotTries); });
  // A robot is drawn on the maps that it is in, which the catalogue tells.
  if (!options_.raw && options_.wantsWhole() && options_.map && options_.map->kind != map::MapKind::Live &&
      session_.robot().liveTopics() &&
      std::any_of(options_.layers.begin(), options_.layers.end(),
                  [](ui::scene::Layer layer) { return ui::scene::specOf(layer).follows_robot; }))
    shot_.await(Awaited::Whereabouts,
                [this] { return !session_.catalogue().loading() || sinceConnected() >= kTopicsWithinS; });
  if (wantsWholeMap())
    shot_.await(Awaited::WholeMap, [this] {
      const bool with_points = options_.layers.contains(ui::scene::Layer::Waypoints);
      return map_.grid() && session_.wholeMap().settled() &&
             !(with_points && session_.wholeMap().waypointsAwaited());
    });
  if (replayed_)
    shot_.await(Awaited::Pictures,
                [this] { return !session_.layerGrids().busy() && replayed_->picturesUnderWay() == 0; });
  else
    shot_.await(Awaited::Topics, [this] { return live_layers_.in() || sinceConnected() > kTopicsWithinS; });
  if (wantsTrack())
    shot_.await(Awaited::Track, [this] { return replayed_->reading()->chunks().wholeSettled(); });
  if (wantsCloud()) shot_.await(Awaited::Cloud, [this] { return cloudIn(); });
  if (wantsClosures() || (options_.quality.closures_over_m && session_.poseGraph().offered())) {
    session_.poseGraph().want();
    shot_.await(Awaited::PoseGraph, [this] { return !session_.poseGraph().loading(); });
  }
}

bool SnapshotRun::needsSubmaps() {
  return (!region_ && options_.wantsSubmaps()) ||
         (options_.quality.disagreement_over && session_.robot().submapSource());
}

bool SnapshotRun::wantsClosures() const {
  return options_.layers.contains(ui::scene::Layer::Closures) && session_.poseGraph().offered();
}

bool SnapshotRun::topicsChoosable() {
  robot::OffersTopics* const of = robot::topicsOfferedBy(session_.robot());
  if (options_.topics.empty() || (of && of->chosen() == options_.topics)) return true;
  fail(kUsage, Text::tr("%1: its topics cannot be chosen (--layers NAME=TOPIC): this only works "
                        "for ROS robots and their recordings.")
                   .arg(options_.robot));
  return false;
}

bool SnapshotRun::drawsScansAlone() const {
  const auto& clouds = session_.live().clouds;
  return automatic_ && !options_.map && !options_.raw && options_.layers.contains(ui::scene::Layer::Cloud) &&
         std::any_of(clouds.begin(), clouds.end(),
                     [](const auto& cloud) { return cloud.second && !cloud.second->empty(); });
}

bool SnapshotRun::recalled() {
  if (!replayed_->at()) {
    const robot::BagInfo& bag = *replayed_->reading()->info();
    if (!options_.at_s) {
      const auto at_s = timeFrom(options_.at, QStringLiteral("--at"), bag);
      if (!at_s) {
        fail(at_s.error().exit_code, at_s.error().sentence);
        return false;
      }
      options_.at_s = *at_s;
    }
    const QString why = incident::notWithinReason(options_.bag, bag, *options_.at_s, !isLocal());
    if (!why.isEmpty()) {
      fail(kUsage, why);
      return false;
    }
    replayed_->reading()->setWhole(wantsTrack());
    shot_.enter(Stage::Reading, seconds());
    recall_->goTo(*options_.at_s);
  }
  if (const auto failure = recall_->failure()) {
    const QString sentence = QString::fromStdString(sentences::sentenceOf(*failure));
    fail(isLocal() ? kUsage : exitCodeOf(failure->kind), words::about(options_.robot, sentence));
    return false;
  }
  if (recall_->in()) {
    for (const auto& [topic, stamp_s] : replayed_->topics()) live_layers_.hear(topic);
  }
  return recall_->in();
}

double SnapshotRun::listWithin() const {
  // Data that is not in a bag will not arrive later: no waiting.
  if (replayed_) return -1;

  return std::clamp(options_.timeout_s / 4, kListAtLeastS, kListWithinS);
}

bool SnapshotRun::wantsWholeInstead() {
  robot::Robot& robot = session_.robot();
  const bool for_submaps = options_.slice != 0 || options_.colors != render::ColorMode::Normal ||
                           options_.layers.contains(ui::scene::Layer::Submaps);
  const bool listed = replayed_ ? session_.world().submaps.has_value() : session_.submaps().listReceived();
  return automatic_ && options_.mode == SnapshotMode::Submaps && !for_submaps && !listed &&
         sinceConnected() > listWithin() && robot.wholeMapSource() != nullptr;
}

void SnapshotRun::useWholeInstead() {
  options_.mode = SnapshotMode::Whole;
  ground_ = Ground::WholeInstead;
  whole_asked_s_ = sinceConnected();
  shown_instead_ =
      (session::listUnreadable(session_.problems())
           ? Text::tr("The robot sent no readable submap list within %1 s: its whole map is drawn instead. "
                      "Pass --mode submaps to wait longer.")
           : Text::tr("The robot sent no submap list within %1 s: its whole map is drawn instead. Pass "
                      "--mode submaps to wait longer."))
          .arg(listWithin());
  if (replayed_)
    shown_instead_ =
        Text::tr("The bag contains no submap list up to this time: a whole map is drawn instead.");
  notes_ << shown_instead_;
  live_layers_.ask(options_.layers, true);
  awaitContent();
}

void SnapshotRun::look() {
  if (picture_ && !shot_.over() && shot_.cutOff(seconds())) {
    shot_.add(Lack::TimeToDraw);
    notes_.prepend(Text::tr("The picture was not finished within %1 s (--timeout): parts of it are empty.")
                       .arg(options_.timeout_s));
    return write();
  }
  if (!shot_.waits()) return;
  if (!connected()) {
    if (shot_.waits() && shot_.timeUp(seconds())) fail(kUnreachable, noConnection());
    return;
  }
  if (!(region_ ? stepRegion() : stepMap())) return;
  const bool online = session_.connection().phase == robot::ConnectionPhase::Online;
  const EndOfWaiting end = shot_.end(seconds(), online, [this] { return !region_ && somethingIn(); });
  if (end == EndOfWaiting::TimeUp) notes_ << words::paragraph({timeUpText(), whatOfTheLink()});
  if (end == EndOfWaiting::LinkLost)
    notes_ << words::paragraph({Text::tr("Not everything had arrived."), whatOfTheLink()});
  if (end != EndOfWaiting::None) return draw(end);
  // Counting a hundred thousand submaps takes a moment, so do not do it every time.
  if (region_ || seconds() - noted_s_ <= std::max(kNoteEveryS, 20 * note_took_s_)) return;
  updateStanding();
  reportProgress();
}

bool SnapshotRun::stepMap() {
  if (wantsWholeInstead()) useWholeInstead();
  // Do not wait for pictures that a bag names but the robot no longer has.
  const bool coming = replayed_ && replayed_->picturesUnderWay() > 0;
  const double waited_s = coming ? 0 : sinceConnected() - whole_asked_s_;
  if (!wantsWholeMap() || map_.look(waited_s) != MapRequest::State::Failed) return true;
  if (!drawsScansAlone()) {
    fail(map_.failure().exit_code, words::about(options_.robot, map_.failure().sentence));
    return false;
  }
  ground_ = Ground::ScansAlone;
  awaitContent();
  notes_ << Text::tr("%1 The robot's sensor data is drawn without a map.").arg(map_.failure().sentence);
  return true;
}

bool SnapshotRun::stepRegion() {
  std::optional<CommandFailure> failure;
  if (!region_->begun())
    failure = region_->begin(session_.robot(), sinceConnected(),
                             std::min(kOffersWithinS, options_.timeout_s / 2), [this] { look(); });
  const auto size = region_->size();
  if (!failure && !size) failure = size.error();
  if (failure) {
    fail(failure->exit_code, failure->sentence);
    return false;
  }
  // Drawing takes a while, too: what has arrived by then is drawn within the remaining time.
  if (*size && !region_->over() && region_->anyCame()) {
    const double draw_s = double((*size)->width()) * double((*size)->height()) / kPixelsDrawnInASecond;
    if (seconds() > options_.timeout_s - std::min(draw_s, options_.timeout_s * kMostOfTimeToDraw)) {
      notes_ << Text::tr("Not everything had arrived within %1 s (--timeout).").arg(options_.timeout_s);
      draw(EndOfWaiting::TimeUp);
    }
  } else if (!shot_.missing()) {
    draw(EndOfWaiting::AllHere);
  }
  return shot_.waits();
}

void SnapshotRun::reportProgress() {
  if (!isSignalConnected(QMetaMethod::fromSignal(&SnapshotRun::progressed))) return;
  if (options_.wantsWhole()) {
    const session::MapSlot& slot = session_.wholeMap();
    Q_EMIT progressed(
        Text::tr("Map %1: %2 % read").arg(slot.name(), QString::number(int(slot.progress() * 100))));
  }
  if (options_.wantsSubmaps()) {
    const QJsonObject submaps = board_->take().report[QLatin1String("submaps")].toObject();
    const auto count = [&](const char* what) { return submaps[QLatin1String(what)].toInt(); };
    Q_EMIT progressed(Text::tr("%1 of %2 submaps, %3 missing, %4 corrupt")
                          .arg(count("drawn"))
                          .arg(count("listed"))
                          .arg(count("missing"))
                          .arg(count("corrupt")));
  }
}

void SnapshotRun::updateStanding() {
  const double began_s = seconds();
  SnapshotStanding standing;
  const bool connected = shot_.connected();
  standing.exit_code = connected ? kIncomplete : kUnreachable;
  standing.sentence =
      connected
          ? Text::tr("Incomplete: no picture could be made within %1 s (--timeout).").arg(options_.timeout_s)
          : noConnection();
  if (connected) standing.sentence = words::paragraph({standing.sentence, whatOfTheLink()});
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
  return replayed_ && !options_.raw && options_.layers.contains(ui::scene::Layer::Track);
}

bool SnapshotRun::lacksSubmaps() {
  return recall_ && recall_->in() && needsSubmaps() && !session_.world().submaps;
}

bool SnapshotRun::wantsCloud() const {
  return !replayed_ && !options_.raw && options_.layers.contains(ui::scene::Layer::DispatchedCloud);
}

void SnapshotRun::askForCloud(const geometry::WorldRect& seen) {
  if (cloud_) return;
  cloud_ = std::make_shared<Cloud>();
  robot::Robot& robot = session_.robot();
  if (!robot.mapDispatch()) {
    cloud_->problem = sentences::absenceReason(robot::Capability::Dispatch,
                                               robot.unavailableReason(robot::Capability::Dispatch));
    return;
  }
  map::CloudRegion region;
  region.centre_m = {seen.center().x(), seen.center().y(), 0};
  region.size_m = {seen.width(), seen.height(), kTallM};
  robot.mapDispatch()->cloud(
      robot::CloudKind::Points, region,
      [cloud = cloud_, region](const robot::Outcome<std::shared_ptr<const map::SpatialCloud>>& outcome) {
        if (outcome && *outcome) {
          cloud->came = clouds::CloudPiece{*outcome, false, region};
        } else if (outcome) {
          cloud->problem = Text::tr("The robot sent an empty cloud of the map.");
        } else {
          cloud->problem = QString::fromStdString(sentences::sentenceOf(outcome.error()));
        }
      });
}

bool SnapshotRun::cloudIn() {
  askForCloud(options_.region ? *options_.region : chooseView().visibleWorld());
  return cloud_->came.has_value() || !cloud_->problem.isEmpty();
}

bool SnapshotRun::somethingIn() const {
  return options_.wantsWhole() ? map_.grid().has_value() : session_.counts().texture_bytes > 0;
}

QString SnapshotRun::timeUpText() const {
  const bool no_list = options_.wantsSubmaps() && !session_.submaps().listReceived();
  const QString text = !no_list ? Text::tr("Not everything had arrived within %1 s (--timeout).")
                       : session::listUnreadable(session_.problems())
                           ? Text::tr(
                                 "The robot sent no readable submap list within %1 s (--timeout). Pass "
                                 "--mode whole to draw its whole map.")
                           : Text::tr(
                                 "The robot sent no submap list within %1 s (--timeout). Pass "
                                 "--mode whole to draw its whole map.");
  return text.arg(options_.timeout_s);
}

void SnapshotRun::fail(int exit_code, const QString& sentence) {
  if (shot_.over()) return;
  error_ = sentence;
  shot_.enter(Stage::Failed, seconds());
  finish(exit_code);
}

void SnapshotRun::finish(int exit_code) {
  timer_.stop();
  Q_EMIT finished(exit_code);
}

std::optional<render::PlacedGrid> SnapshotRun::wholeGrid() const {
  return options_.wantsWhole() ? map_.grid() : std::nullopt;
}

geometry::ViewTransform SnapshotRun::chooseView() const {
  geometry::ViewTransform view;
  view.width_px = options_.size_px.width();
  view.height_px = options_.size_px.height();
  view.rotation_rad = options_.rotation_rad;
  if (options_.region) {
    view.center_m = options_.region->center();
    if (options_.scale_m_per_px > 0) view.scale_m_per_px = options_.scale_m_per_px;
    return view;
  }
  if (!options_.center_m) {
    geometry::WorldRect bounds;
    if (options_.wantsSubmaps()) bounds.extend(session_.contentBounds());
    const auto grid = wholeGrid();
    if (grid) bounds.extend(grid->reference.bounds());
    if (bounds.empty() && options_.layers.contains(ui::scene::Layer::Cloud)) {
      for (const auto& [topic, cloud] : session_.live().clouds) {
        if (!cloud) continue;
        for (const map::CloudPoint& point : *cloud) bounds.extend(Eigen::Vector2d(point.x_m, point.y_m));
      }
    }
    return view.fitted(bounds, kFitMarginPx);
  }
  view.center_m = *options_.center_m;
  view.scale_m_per_px = options_.scale_m_per_px;
  return view;
}

ui::shot::Look SnapshotRun::shown() const {
  ui::shot::Look look;
  look.view = view_;
  look.layers = options_.layers;
  for (const auto& [layer, drawn] : {std::pair(ui::scene::Layer::Submaps, options_.wantsSubmaps()),
                                     std::pair(ui::scene::Layer::WholeMap, options_.wantsWhole())}) {
    if (drawn) look.layers.insert(layer);
    if (!drawn) look.layers.erase(layer);
  }
  look.dark = options_.dark;
  look.colors = options_.colors;
  // A submap without the chosen slice is complete: its picture stays the same unless the marks are asked for.
  look.slices_marked = options_.named.contains(ui::scene::Layer::Problems);
  look.robot_anyway = options_.robot_anyway;
  return look;
}

std::unique_ptr<ui::shot::Picture> SnapshotRun::makePicture(std::shared_ptr<const ui::scene::Track> track) {
  if (!options_.raw) {
    ui::shot::Look look = shown();
    if (!wholeGrid()) look.layers.erase(ui::scene::Layer::WholeMap);
    look.layers.erase(ui::scene::Layer::Regions);
    if (region_) look.layers.insert(ui::scene::Layer::Regions);
    if (region_) look.regions = region_->still();
    look.track = std::move(track);
    if (wantsCloud() && cloud_) look.cloud = cloud_->came;
    return std::make_unique<ui::shot::ScenePicture>(std::move(look), session_, workers_);
  }
  const bool whole = region_ || options_.mode == SnapshotMode::Whole;
  ui::shot::RawContent content = ui::shot::rawContent(session_, view_, whole);
  if (whole) content.grid = wholeGrid();
  if (region_) {
    if (const auto missing = region_->putInto(content)) {
      shot_.add(Lack::Region);
      notes_ << *missing;
    }
  }
  return ui::shot::makeRawPicture(std::move(content), workers_);
}

bool SnapshotRun::waypointsLost() const {
  if (options_.raw || !options_.wantsWhole() || !options_.layers.contains(ui::scene::Layer::Waypoints))
    return false;
  const auto& rows = session_.problems().rows();
  return std::any_of(rows.begin(), rows.end(), [](const session::LoggedProblem& row) {
    return !row.resolved && row.problem.subject.kind == map::SubjectKind::Places &&
           row.problem.code == map::ProblemCode::Unavailable;
  });
}

bool SnapshotRun::overlaysLost() const {
  if (options_.raw || !wholeGrid() || !options_.layers.contains(ui::scene::Layer::Overlays)) return false;
  const auto& notes = session_.wholeMap().shown().notes;
  return std::any_of(notes.begin(), notes.end(),
                     [](const map::Problem& note) { return note.code == map::ProblemCode::Unreadable; });
}

void SnapshotRun::draw(EndOfWaiting why) {
  const bool settled =
      why == EndOfWaiting::AllHere ||
      (why == EndOfWaiting::Collected && (!options_.wantsSubmaps() || session_.settled(kSnapshotTries)));
  if (region_) {
    const auto notes = region_->notes(whatOfTheLink());
    if (!notes) return fail(notes.error().exit_code, notes.error().sentence);
    options_.scale_m_per_px = region_->scale();
    options_.size_px = **region_->size();
    notes_ += *notes;
  }
  if (!region_ && options_.mode == SnapshotMode::Whole && wantsWholeMap() && !map_.grid()) {
    const QString which = options_.map
                              ? Text::tr("map %1").arg(QString::fromStdString(map::toText(*options_.map)))
                              : Text::tr("its map");
    fail(exitCodeOf(map::FailureKind::TimedOut),
         words::paragraph(
             QStringList{
                 Text::tr("%1: %2 had not arrived within %3 s (%4). There is nothing to draw.")
                     .arg(options_.robot, which, passed(options_.settle_s ? sinceConnected() : seconds()),
                          options_.settle_s ? QStringLiteral("--settle") : QStringLiteral("--timeout")),
                 whatOfTheLink()} +
             map_.liveTroubles().mid(0, 1)));
    return;
  }
  shot_.enter(Stage::Drawing, seconds());
  // Drawing takes a while. Messages that arrive meanwhile must change neither the picture nor the report.
  session_.standStill();
  // Closing drops everything read from a bag.
  const auto track = wantsTrack() ? ui::trackOfBag(*replayed_->reading()) : nullptr;
  const auto holes =
      wantsTrack() ? replayed_->reading()->chunks().holes(std::nextafter(*options_.at_s, HUGE_VAL), HUGE_VAL)
                   : std::vector<replay::Hole>();
  session_.close();
  chosen_.emplace();
  chosen_->counts = session_.counts();
  chosen_->problems = problemLines(session_.problems());
  chosen_->refused = anyRefused(session_.problems());
  if (const auto grid = wholeGrid()) {
    chosen_->map = mapJson(*map_.key(), session_.wholeMap().name(), grid->reference);
  }
  shot_.addIf(!settled, Lack::NotSettled);
  shot_.addIf(options_.wantsSubmaps() && !session::submapsComplete(chosen_->counts, session_.problems()),
              Lack::Submaps);
  shot_.addIf(wantsWholeMap() && !map_.complete(), Lack::WholeMap);
  shot_.addIf(waypointsLost(), Lack::Waypoints);
  shot_.addIf(overlaysLost(), Lack::Overlays);
  const map::WholeMap& whole = session_.wholeMap().shown();
  const bool overlays = !options_.raw && wholeGrid() && options_.layers.contains(ui::scene::Layer::Overlays);
  if (overlays && !overlaysLost() && !whole.broken_overlays.empty()) {
    // A robot's own, which it can live with.
    const Fault unreadable(robot::fault::FeaturesUnreadable, {std::int64_t(whole.broken_overlays.size())});
    notes_ << words::about(sentences::nameOf(map::subjectOf(whole.key, whole.name)),
                           sentences::sentenceOf(unreadable));
  }
  shot_.addIf(region_ && !region_->complete(), Lack::Region);
  shot_.addIf(wantsCloud() && !(cloud_ && cloud_->came), Lack::Cloud);
  if (options_.named.contains(ui::scene::Layer::Closures) && !session_.poseGraph().offered()) {
    shot_.add(Lack::PoseGraph);
    notes_ << words::paragraph(
        {Text::tr("Loop closures are not drawn."),
         sentences::absenceReason(robot::Capability::PoseGraph,
                                  session_.robot().unavailableReason(robot::Capability::PoseGraph))});
  }
  if (wantsClosures() && !session_.poseGraph().closures()) {
    shot_.add(Lack::PoseGraph);
    notes_ << words::paragraph(
        {Text::tr("Loop closures are not drawn: the pose graph was not read."),
         session_.poseGraph().failure()
             ? QString::fromStdString(sentences::failureReason(*session_.poseGraph().failure()))
             : QString()});
  }
  shot_.addIf(!holes.empty() || !bagLosses(session_.problems()).isEmpty(), Lack::PartsOfBag);
  if (!holes.empty()) notes_ << sentences::sentenceOf(replay::faultOf(holes));
  // Also printed to standard error although nothing is missing.
  const auto say = [this](const QString& note) {
    notes_ << note;
    shown_instead_ = words::paragraph({shown_instead_, note});
  };
  if (wantsCloud() && cloud_ && !cloud_->problem.isEmpty()) notes_ << cloud_->problem;
  // Nothing may look as if it had been recorded.
  if (replayed_ && !options_.map && options_.wantsWhole() && map_.key() &&
      map_.key()->kind != map::MapKind::Live) {
    say(isLocal() ? Text::tr("The bag contains no map up to this time: the one recorded with it is drawn.")
                  : Text::tr("The bag contains no map up to this time: the robot's present map is drawn."));
  }
  if (lacksSubmaps())
    notes_ << Text::tr("The bag contains no submap list up to this time: there are no submaps to draw.");
  checkChosenTopics();
  if (!replayed_) reportUnplaced();
  for (const QString& topic : live_layers_.silent()) {
    // Nothing is requested for a bag: data that is not in it is not missing.
    if (replayed_) break;
    notes_ << Text::tr("Nothing arrived on topic %1 within %2 s.").arg(topic, passed(sinceConnected()));
  }
  for (const ui::scene::Layer layer : live_layers_.unfillable()) {
    if (!options_.named.contains(layer)) continue;
    say((replayed_ ? Text::tr("Layer %1 is empty: the bag has no topic for it.")
                   : Text::tr("Layer %1 is empty: the robot has no topic for it."))
            .arg(ui::scene::layerName(layer)));
  }
  for (const ui::scene::Layer layer : {ui::scene::Layer::Coverage, ui::scene::Layer::Disagreement}) {
    if (options_.wantsSubmaps() || !options_.named.contains(layer)) continue;
    say(Text::tr("Layer %1 is empty: it is about submaps, and a whole map is drawn (--mode submaps).")
            .arg(ui::scene::layerName(layer)));
    shot_.add(Lack::Submaps);
  }
  const session::SubmapCounts& counts = chosen_->counts;
  if (counts.without_slice > 0 && counts.without_slice == counts.listed) {
    notes_ << Text::tr("No submap has a slice %1 (--slice): the picture is empty.").arg(options_.slice);
  }
  view_ = chooseView();
  updateStanding();
  Q_EMIT contentChosen();
  picture_ = makePicture(track);
  connect(picture_.get(), &ui::shot::Picture::finished, this, &SnapshotRun::write);
  picture_->start();
  if (const auto* const drawn = dynamic_cast<const ui::shot::ScenePicture*>(picture_.get()))
    noteDrawn(*drawn);
}

void SnapshotRun::noteDrawn(const ui::shot::ScenePicture& drawn) {
  notes_ += robotNotes(drawn.scene(), session_);
  if (!drawn.agreementFault()) return;
  notes_ << sentences::wordsOf(*drawn.agreementFault());
  shot_.add(Lack::Cells);
}

/// What lacks its transform is not where it belongs: nowhere.
void SnapshotRun::reportUnplaced() {
  QStringList topics = live_layers_.unplaced();
  for (const auto& [topic, count] : live_layers_.unplacedMarkers()) {
    topics << topic;
    notes_ << Text::tr("%1 markers of %2 are missing: the transforms that place them had not arrived.",
                       nullptr, count)
                  .arg(QString::number(count), topic);
  }
  shot_.addIf(!topics.isEmpty(), Lack::Placement);
}

void SnapshotRun::checkChosenTopics() {
  robot::OffersTopics* const of = robot::topicsOfferedBy(session_.robot());
  if (!of || !of->offered()) return;
  for (const auto& [stream, topic] : options_.topics) {
    if (of->choicesFor(stream).contains(topic)) continue;
    QString fitting = words::listed(of->choicesFor(stream));
    if (fitting.isEmpty()) fitting = Text::tr("none");
    notes_ << Text::tr("Topic %1 does not exist or its type does not fit the layer. Topics that fit: %2.")
                  .arg(topic, fitting);
    shot_.add(Lack::Topic);
  }
}

void SnapshotRun::write() {
  if (shot_.over()) return;
  made_ = picture_->made();
  if (const auto grid = wholeGrid(); grid && grid->cells->trouble().any()) {
    shot_.add(Lack::Cells);
    notes_.prepend(sentences::wordsOf(grid->cells->trouble()));
  }
  if (session_.lostPictures() > 0) {
    shot_.add(Lack::Cells);
    notes_.prepend(
        Text::tr("%1 submaps could not be read back from the disk: parts of the picture are empty.", nullptr,
                 int(session_.lostPictures()))
            .arg(session_.lostPictures()));
  }
  if (const auto why = overItsSource()) return fail(kUsage, *why);
  if (const auto fault = picture_->write(options_.output)) return fail(kUsage, sentences::wordsOf(*fault));
  shot_.enter(Stage::Done, seconds());
  finish(shot_.complete() ? kDone : chosen_->refused ? exitCodeOf(map::FailureKind::Refused) : kIncomplete);
}

std::optional<QString> SnapshotRun::overItsSource() const {
  if (options_.force) return std::nullopt;
  const session::MapSlot& slot = session_.wholeMap();
  return overOwnSource({options_.output, options_.report},
                       sourceFilesOf(options_.robot, slot.key().id, slot.shown().path));
}

QStringList SnapshotRun::warnings() const {
  QStringList all;
  if (!error_.isEmpty()) all << error_;
  all += chosen_ ? chosen_->problems : problemLines(session_.problems());
  return all + map_.notes() + notes_;
}

QJsonObject SnapshotRun::report() const {
  const session::SubmapCounts counts = chosen_ ? chosen_->counts : session_.counts();
  QJsonObject report{
      {QStringLiteral("complete"), shot_.complete()},
      {QStringLiteral("mode"),
       options_.mode == SnapshotMode::Whole ? QStringLiteral("whole") : QStringLiteral("submaps")},
      {QStringLiteral("uuid"), QString::fromStdString(session_.submaps().uuid())},
      {QStringLiteral("submaps"), submapsJson(counts)},
      {QStringLiteral("painted"), toThousandths(made_)},
      {QStringLiteral("seconds"),
       QJsonObject{{QStringLiteral("connect"), secondsOrNull(shot_.enteredAt(Stage::Settling))},
                   {QStringLiteral("first_paint"),
                    secondsOrNull(first_paint_s_ < 0 ? std::nullopt : std::optional(first_paint_s_))},
                   {QStringLiteral("complete"),
                    secondsOrNull(shot_.over() ? shot_.enteredAt(shot_.stage()) : std::nullopt)}}},
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
  if (region_) report[QStringLiteral("region")] = region_->json();
  if (chosen_ && chosen_->map) report[QStringLiteral("map")] = *chosen_->map;
  return report;
}

}  // namespace mapwright::app

#include "moc_snapshot_run.cpp"
