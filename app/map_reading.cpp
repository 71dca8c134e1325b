#include "app/map_reading.h"

#include <algorithm>

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QEventLoop>
#include <QTimer>

#include "app/exit_code.h"
#include "app/fetch_ahead.h"
#include "app/map_wish.h"
#include "app/one_line.h"
#include "app/report.h"
#include "app/robot_factory.h"
#include "render/compose_grid.h"
#include "robot/address.h"
#include "scene/layer.h"
#include "sentences/absence_sentence.h"
#include "sentences/failure_sentence.h"
#include "sentences/fault_sentence.h"
#include "work/budgets.h"

namespace mapwright::app {
namespace {

class MapReadingText {
  Q_DECLARE_TR_FUNCTIONS(MapReading)
};

constexpr int kMapLookEveryMs = 10;
constexpr qsizetype kLongestAddress = 200;
constexpr int kMapConnectAttempts = 3;
constexpr int kMapTries = 3;
constexpr int kMapFarewellMs = 200;  // how long to wait for the result of a change that was given up

double secondsSince(SteadyTime start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Requests only what the command shows.
session::Session::Options quietOptions(MapReading::Purpose purpose,
                                       const std::shared_ptr<work::Workers>& workers) {
  session::Session::Options options;
  options.workers = workers;
  options.scheduler.max_concurrent = kFetchAhead;
  options.overview = false;
  options.maps = false;
  options.sidecar_folder = gridCacheFolder();
  options.basics = {purpose == MapReading::Purpose::Submaps, false, false};
  return options;
}

}  // namespace

bool CommandTime::over(double grace_s) const { return secondsSince(start.begun) > timeout_s + grace_s; }

MapReading::MapReading(std::unique_ptr<robot::Robot> robot, QString address, CommandTime time,
                       Purpose purpose, std::shared_ptr<work::Workers> workers)
    : workers_(std::move(workers)),
      session_(std::move(robot), quietOptions(purpose, workers_)),
      address_(std::move(address)),
      time_(time) {}

bool MapReading::waitUntil(const std::function<bool()>& done, double at_most_s) {
  const QDeadlineTimer patience(at_most_s < 1e6 ? qint64(at_most_s * 1000) : -1, Qt::PreciseTimer);
  QEventLoop loop;
  QTimer look;
  look.setTimerType(Qt::PreciseTimer);
  bool is_done = done();
  QObject::connect(&look, &QTimer::timeout, &loop, [&] {
    is_done = done();
    if (is_done || time_.over() || patience.hasExpired()) loop.quit();
  });
  look.start(kMapLookEveryMs);
  if (!is_done) loop.exec();
  return is_done;
}

bool MapReading::local() const { return session_.robot().isLocal(); }

std::vector<std::string> MapReading::sourceFiles() const {
  const session::MapSlot& slot = session_.wholeMap();
  return sourceFilesOf(address_, slot.key().id, slot.shown().path);
}

CommandFailure MapReading::failure(int exit_code, const QString& sentence) const {
  return {exit_code, QStringLiteral("%1: %2").arg(oneLine(address_, kLongestAddress), sentence)};
}

CommandFailure MapReading::failure(const map::Failure& failed) const {
  return failure(exitCodeOf(failed), QString::fromStdString(sentences::sentenceOf(failed)));
}

void MapReading::giveUp(const robot::Call& call, const std::function<bool()>& over) const {
  call.cancel();
  QEventLoop loop;
  const QDeadlineTimer patience(kMapFarewellMs);
  while (!over() && !patience.hasExpired()) loop.processEvents(QEventLoop::AllEvents, kMapLookEveryMs);
}

map::Failure MapReading::tooLate(map::Failure failure) const {
  failure.kind = map::FailureKind::TimedOut;
  failure.detail = MapReadingText::tr("it did not answer within %1 s").arg(time_.timeout_s).toStdString();
  return failure;
}

CommandFailure MapReading::lacks(robot::Capability capability) const {
  return failure(local() ? kUsage : kRobotError,
                 sentences::whyAbsent(capability, session_.robot().whyNot(capability)));
}

CommandResult<std::unique_ptr<MapReading>> MapReading::open(const QString& address, const Access& access,
                                                            CommandTime time, Purpose purpose,
                                                            std::shared_ptr<work::Workers> workers) {
  if (address.isEmpty()) {
    return tl::make_unexpected(CommandFailure{
        kUsage,
        MapReadingText::tr("Which robot? Pass --robot ADDRESS or set MAPWRIGHT_ROBOT; a file works too.")});
  }
  Access timed = access;
  timed.timeout = std::chrono::milliseconds(qint64(time.timeout_s * 1000));
  auto robot = makeRobot(address, timed, DemoTime::Frozen);
  if (!robot) return tl::make_unexpected(CommandFailure{kUsage, robot.error()});
  std::unique_ptr<MapReading> reading(
      new MapReading(std::move(*robot), address, time, purpose, std::move(workers)));
  session::Session& session = reading->session_;
  if (purpose == Purpose::Bags && session.robot().bagLibrary()) {
    reading->online_since_ = std::chrono::steady_clock::now();
    return reading;
  }
  session.open();
  const auto phase = [&] { return session.connection().phase; };
  reading->waitUntil([&] {
    return phase() == robot::ConnectionPhase::Online || phase() == robot::ConnectionPhase::Refused ||
           (phase() == robot::ConnectionPhase::Interrupted &&
            (session.connection().attempt >= kMapConnectAttempts ||
             session.connection().failure == map::FailureKind::NotARobot));
  });
  if (phase() != robot::ConnectionPhase::Online) {
    const bool file = reading->local() && phase() == robot::ConnectionPhase::Refused;
    const QString reason = whyNotConnected(session.connection());
    return tl::make_unexpected(reading->failure(
        file ? kUsage : exitCodeOf(session.connection().failure, kUnreachable),
        reason.isEmpty() ? MapReadingText::tr("no connection within %1 s.").arg(time.timeout_s) : reason));
  }
  reading->online_since_ = std::chrono::steady_clock::now();
  return reading;
}

CommandResult<map::CatalogueEntry> MapReading::change(const robot::MapOrder& order) {
  robot::MapAdministration* const maps = session_.robot().mapAdministration();
  if (!maps) return tl::make_unexpected(lacks(robot::Capability::Administration));
  const auto obstacle = maps->obstacle(order.change, nullptr);
  if (obstacle == robot::Obstacle::NotOffered) {
    return tl::make_unexpected(
        failure(local() ? kUsage : kRobotError, sentences::whyNotNow(order.change, *obstacle)));
  }
  auto outcome = ask<map::CatalogueEntry>(
      [&](robot::OutcomeTo<map::CatalogueEntry> reply) { return maps->carryOut(order, std::move(reply)); });
  if (outcome) return std::move(*outcome);
  outcome.error().asked_for = map::AskedFor::Change;
  return tl::make_unexpected(failure(outcome.error()));
}

CommandResult<const std::vector<map::CatalogueEntry>*> MapReading::catalogue() {
  session::Catalogue& catalogue = session_.catalogue();
  if (!catalogue.offered()) {
    return tl::make_unexpected(lacks(robot::Capability::Catalogue));
  }
  if (!catalogue.asOf() && !catalogue.loading()) catalogue.refresh();
  if (!waitUntil([&] { return !catalogue.loading() && (catalogue.asOf() || catalogue.failure()); })) {
    return tl::make_unexpected(
        failure(exitCodeOf(map::FailureKind::TimedOut),
                MapReadingText::tr("It did not answer within %1 s.").arg(time_.timeout_s)));
  }
  if (catalogue.failure()) {
    return tl::make_unexpected(failure(local() ? kUsage : exitCodeOf(catalogue.failure()->kind),
                                       QString::fromStdString(sentences::sentenceOf(*catalogue.failure()))));
  }
  // An incomplete list is a problem of its own.
  insistOnAll();
  return &catalogue.entries();
}

QStringList MapReading::problems(map::Severity least) const {
  QStringList lines;
  for (const session::LoggedProblem& row : session_.problems().rows()) {
    // Problems of the robot in general, or a missing submap list, do not concern the requested data.
    const map::SubjectKind kind = row.problem.subject.kind;
    const bool asked_for =
        kind != map::SubjectKind::Robot &&
        !(kind == map::SubjectKind::SubmapList && row.problem.code == map::ProblemCode::Unavailable);
    if (!row.resolved && asked_for && row.problem.severity >= least) lines << problemLine(row.problem);
  }
  return lines;
}

void MapReading::insistOnReadable() {
  for (const session::LoggedProblem& row : session_.problems().rows()) {
    const bool unreadable =
        row.problem.code == map::ProblemCode::Unreadable && row.problem.severity >= map::Severity::Warning;
    if (!row.resolved && unreadable) complete_ = false;
  }
}

QStringList MapReading::warnings() const {
  QStringList all = bagLosses(session_.problems()) + notes_ + problems(map::Severity::Warning);
  all.removeDuplicates();  // problems of waypoints are found again when their map is opened
  return all;
}

QJsonObject MapReading::facts() const {
  QJsonObject facts = trafficJson(session_.counts());
  for (auto it = facts_.begin(); it != facts_.end(); ++it) facts[it.key()] = it.value();
  return facts;
}

CommandResult<render::PlacedGrid> MapReading::map(const QString& id, double resolution_m) {
  if (id == QLatin1String("submaps")) return submaps(resolution_m);
  if (id.isEmpty() || id == QLatin1String("live")) {
    session_.want(QStringLiteral("command"), scene::layerStreams(scene::Layer::WholeMap));
  }
  MapWish wish(session_, id, true);
  wish.agreeToWhole();
  const bool in =
      waitUntil([&] { return wish.look(secondsSince(online_since_)) != MapWish::State::Waiting; });
  if (!in) {
    const QString late = MapReadingText::tr("The map had not arrived within %1 s.").arg(time_.timeout_s);
    return tl::make_unexpected(
        failure(exitCodeOf(map::FailureKind::TimedOut),
                (QStringList(late) + wish.liveTroubles().mid(0, 1)).join(QLatin1Char(' '))));
  }
  if (wish.look(secondsSince(online_since_)) == MapWish::State::Failed) {
    return tl::make_unexpected(failure(wish.failure().exit_code, wish.failure().sentence));
  }
  session_.standStill();
  complete_ = complete_ && wish.complete() && problems(map::Severity::Error).isEmpty();
  notes_ += wish.notes();
  name_ = session_.wholeMap().name();
  const render::PlacedGrid grid = *wish.grid();
  facts_[QStringLiteral("map")] = mapJson(*wish.key(), name_, grid.reference);
  return grid;
}

CommandResult<render::PlacedGrid> MapReading::submaps(double resolution_m) {
  if (!session_.robot().submapSource()) {
    return tl::make_unexpected(lacks(robot::Capability::Submaps));
  }
  const bool settled = waitUntil([&] { return session_.settled(kMapTries); });
  session_.standStill();
  session_.close();
  const session::SubmapCounts counts = session_.counts();
  complete_ = complete_ && settled && submapsComplete(counts);
  facts_[QStringLiteral("submaps")] = submapsJson(counts);
  facts_[QStringLiteral("uuid")] = QString::fromStdString(session_.submaps().uuid());
  if (!settled) {
    notes_ << (counts.list_received
                   ? MapReadingText::tr("Not everything had arrived within %1 s (--timeout).")
                   : MapReadingText::tr("The robot sent no submap list within %1 s (--timeout)."))
                  .arg(time_.timeout_s);
  }
  std::vector<render::PlacedTexture> textures;
  for (const auto& [id, row] : session_.submaps().rows()) {
    if (const auto placement = session_.submaps().placement(id, session_.slice())) {
      textures.push_back({id, placement->texture, placement->world_from_texture, 0});
    }
  }
  if (textures.empty()) {
    // A snapshot would be empty, but a grid of no size is impossible.
    const QStringList why = refused() ? problems(map::Severity::Error) : warnings();
    return tl::make_unexpected(
        failure(complete_   ? int(kRobotError)
                : refused() ? exitCodeOf(map::FailureKind::Refused)
                            : int(kIncomplete),
                counts.listed == 0 && settled
                    ? MapReadingText::tr("It has no submaps yet.")
                    : MapReadingText::tr("None of its submaps could be loaded. %1").arg(firstOf(why))));
  }
  render::DenseCache cache(work::budgetsFrom().dense + work::budgetsFrom().tiles);  // no tiles are kept
  bool in_time = true;
  auto made = render::composeGrid(textures, resolution_m, cache,
                                  [&](double) {
                                    in_time = !time_.over(time_.start.grace.draw_s);
                                    return in_time;
                                  },
                                  {workers_});
  if (!in_time) {
    return tl::make_unexpected(failure(
        kIncomplete, MapReadingText::tr(
                         "%1 of %2 submaps had arrived, but drawing them took longer than %3 s (--timeout).")
                         .arg(counts.shown)
                         .arg(counts.listed)
                         .arg(time_.timeout_s)));
  }
  if (!made) return tl::make_unexpected(failure(kRobotError, sentences::wordsOf(made.error())));
  return render::PlacedGrid{made->cells, made->reference};
}

}  // namespace mapwright::app
