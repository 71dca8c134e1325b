#include "app/map_reading.h"

#include <algorithm>

#include <QEventLoop>
#include <QTimer>

#include "app/exit_code.h"
#include "app/map_wish.h"
#include "app/one_line.h"
#include "app/report.h"
#include "app/robot_factory.h"
#include "render/compose_grid.h"
#include "robot/address.h"
#include "scene/layer.h"

namespace mapwright::app {
namespace {

constexpr int kLookEveryMs = 10;
constexpr qsizetype kLongestAddress = 200;
constexpr int kConnectAttempts = 3;
constexpr int kTries = 3;

double secondsSince(SteadyTime start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Only what the command shows is asked for.
session::Session::Options quietOptions(MapReading::Purpose purpose) {
  session::Session::Options options;
  options.overview = false;
  options.maps = false;
  options.sidecar_folder = gridCacheFolder();
  options.basics = {purpose == MapReading::Purpose::Submaps, false, false};
  return options;
}

}  // namespace

bool CommandTime::over(double grace_s) const { return secondsSince(start.begun) > timeout_s + grace_s; }

MapReading::MapReading(std::unique_ptr<robot::Robot> robot, QString address, CommandTime time,
                       Purpose purpose)
    : session_(std::move(robot), quietOptions(purpose)), address_(std::move(address)), time_(time) {}

bool MapReading::waitUntil(const std::function<bool()>& done) {
  QEventLoop loop;
  QTimer look;
  look.setTimerType(Qt::PreciseTimer);
  bool is_done = done();
  QObject::connect(&look, &QTimer::timeout, &loop, [&] {
    is_done = done();
    if (is_done || time_.over()) loop.quit();
  });
  look.start(kLookEveryMs);
  if (!is_done) loop.exec();
  return is_done;
}

bool MapReading::local() const { return session_.robot().address().startsWith(QLatin1String("file:")); }

std::vector<std::string> MapReading::sourceFiles() const {
  const session::MapSlot& slot = session_.wholeMap();
  return sourceFilesOf(address_, slot.key().id, slot.shown().path);
}

CommandFailure MapReading::failure(int exit_code, const QString& sentence) const {
  return {exit_code, QStringLiteral("%1: %2").arg(oneLine(address_, kLongestAddress), sentence)};
}

CommandResult<std::unique_ptr<MapReading>> MapReading::open(const QString& address, const Access& access,
                                                            CommandTime time, Purpose purpose) {
  if (address.isEmpty()) {
    return tl::make_unexpected(CommandFailure{
        kUsage,
        QStringLiteral("Which robot? Give --robot ADDRESS or set MAPWRIGHT_ROBOT; a file works too.")});
  }
  auto robot = makeRobot(address, access, DemoTime::Frozen);
  if (!robot) return tl::make_unexpected(CommandFailure{kUsage, robot.error()});
  std::unique_ptr<MapReading> reading(new MapReading(std::move(*robot), address, time, purpose));
  session::Session& session = reading->session_;
  session.open();
  const auto phase = [&] { return session.connection().phase; };
  reading->waitUntil([&] {
    return phase() == robot::ConnectionPhase::Online || phase() == robot::ConnectionPhase::Refused ||
           (phase() == robot::ConnectionPhase::Interrupted &&
            (session.connection().attempt >= kConnectAttempts ||
             session.connection().failure == map::FailureKind::NotARobot));
  });
  if (phase() != robot::ConnectionPhase::Online) {
    const bool file = reading->local() && phase() == robot::ConnectionPhase::Refused;
    const QString reason = whyNotConnected(session.connection());
    return tl::make_unexpected(reading->failure(
        file ? kUsage : exitCodeOf(session.connection().failure, kUnreachable),
        reason.isEmpty() ? QStringLiteral("no connection within %1 s.").arg(time.timeout_s) : reason));
  }
  reading->online_since_ = std::chrono::steady_clock::now();
  return reading;
}

CommandResult<const std::vector<map::CatalogueEntry>*> MapReading::catalogue() {
  session::Catalogue& catalogue = session_.catalogue();
  if (!catalogue.offered()) {
    return tl::make_unexpected(failure(kRobotError, QStringLiteral("This robot offers no list of maps.")));
  }
  if (!catalogue.asOf() && !catalogue.loading()) catalogue.refresh();
  if (!waitUntil(
          [&] { return !catalogue.loading() && (catalogue.asOf() || !catalogue.error().isEmpty()); })) {
    return tl::make_unexpected(
        failure(exitCodeOf(map::FailureKind::TimedOut),
                QStringLiteral("It did not answer within %1 s.").arg(time_.timeout_s)));
  }
  if (!catalogue.error().isEmpty()) {
    return tl::make_unexpected(
        failure(local() ? kUsage : exitCodeOf(catalogue.failure()), catalogue.error()));
  }
  // A part of the list that could not be had is a problem of its own.
  complete_ = complete_ && problems(map::Severity::Warning).isEmpty();
  return &catalogue.entries();
}

QStringList MapReading::problems(map::Severity least) const {
  QStringList lines;
  for (const session::LoggedProblem& row : session_.problems().rows()) {
    // What concerns the robot as such, or a submap list that has not come yet, is not what was asked for.
    const map::SubjectKind kind = row.problem.subject.kind;
    const bool asked_for =
        kind != map::SubjectKind::Robot &&
        !(kind == map::SubjectKind::SubmapList && row.problem.code == map::ProblemCode::Unavailable);
    if (!row.resolved && asked_for && row.problem.severity >= least) lines << problemLine(row.problem);
  }
  return lines;
}

QStringList MapReading::warnings() const { return notes_ + problems(map::Severity::Warning); }

QJsonObject MapReading::facts() const {
  QJsonObject facts = trafficJson(session_.counts());
  for (auto it = facts_.begin(); it != facts_.end(); ++it) facts[it.key()] = it.value();
  return facts;
}

CommandResult<render::PlacedGrid> MapReading::map(const QString& id, double resolution_m) {
  if (id == QLatin1String("submaps")) return submaps(resolution_m);
  if (id.isEmpty() || id == QLatin1String("live")) {
    session_.want(QStringLiteral("command"), scene::layerTopics(scene::Layer::WholeMap));
  }
  MapWish wish(session_, id, true);
  const bool in =
      waitUntil([&] { return wish.look(secondsSince(online_since_)) != MapWish::State::Waiting; });
  if (!in) {
    return tl::make_unexpected(
        failure(exitCodeOf(map::FailureKind::TimedOut),
                QStringLiteral("The map had not arrived within %1 s.").arg(time_.timeout_s)));
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
    return tl::make_unexpected(failure(kRobotError, QStringLiteral("This robot has no submaps.")));
  }
  const bool settled = waitUntil([&] { return session_.settled(kTries); });
  session_.standStill();
  session_.close();
  const session::SubmapCounts counts = session_.counts();
  complete_ = complete_ && settled && submapsComplete(counts);
  facts_[QStringLiteral("submaps")] = submapsJson(counts);
  facts_[QStringLiteral("uuid")] = QString::fromStdString(session_.book().uuid());
  if (!settled) {
    notes_ << (counts.list_received
                   ? QStringLiteral("Not everything had arrived within %1 s (--timeout).")
                   : QStringLiteral("The robot sent no submap list within %1 s (--timeout)."))
                  .arg(time_.timeout_s);
  }
  std::vector<render::PlacedTexture> textures;
  for (const auto& [id, row] : session_.book().rows()) {
    if (const auto placement = session_.book().placement(id, session_.slice())) {
      textures.push_back({id, placement->texture, placement->world_from_texture, 0});
    }
  }
  if (textures.empty()) {
    // What a snapshot would draw as an empty picture cannot be a grid: it has no size.
    const QStringList why = warnings();
    return tl::make_unexpected(
        failure(complete_ ? kRobotError : kIncomplete,
                counts.listed == 0 && settled
                    ? QStringLiteral("It has no submap yet.")
                    : QStringLiteral("None of its submaps could be had. %1").arg(firstOf(why))));
  }
  render::DenseCache cache(std::size_t(256) << 20);
  bool in_time = true;
  auto made = render::composeGrid(textures, resolution_m, cache, [&](double) {
    in_time = !time_.over(time_.start.grace.draw_s);
    return in_time;
  });
  if (!in_time) {
    return tl::make_unexpected(failure(
        kIncomplete, QStringLiteral("%1 of %2 submaps had arrived, but they could not be put together "
                                    "within %3 s (--timeout).")
                         .arg(counts.shown)
                         .arg(counts.listed)
                         .arg(time_.timeout_s)));
  }
  if (!made) return tl::make_unexpected(failure(kRobotError, QString::fromStdString(made.error())));
  return render::PlacedGrid{made->cells, made->reference};
}

}  // namespace mapwright::app
