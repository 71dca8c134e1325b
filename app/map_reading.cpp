#include "app/map_reading.h"

#include <cstdio>

#include <QElapsedTimer>
#include <QEventLoop>
#include <QTimer>

#include "app/exit_code.h"
#include "app/one_line.h"
#include "app/robot_factory.h"
#include "render/compose_grid.h"
#include "scene/layer.h"

namespace mapwright::app {
namespace {

constexpr int kLookEveryMs = 10;
constexpr qsizetype kLongestAddress = 200;
constexpr int kConnectAttempts = 3;
constexpr double kLiveMapWithinS = 8;
constexpr int kTries = 3;

QString text(const std::string& utf8) { return QString::fromStdString(utf8); }

session::Session::Options quietOptions() {
  session::Session::Options options;
  options.overview = false;
  options.sidecar_folder = gridCacheFolder();
  return options;
}

}  // namespace

MapReading::MapReading(std::unique_ptr<robot::Robot> robot, QString address, double timeout_s)
    : session_(std::move(robot), quietOptions()), address_(std::move(address)), timeout_s_(timeout_s) {}

bool MapReading::waitUntil(const std::function<bool()>& done) {
  QElapsedTimer clock;
  clock.start();
  QEventLoop loop;
  QTimer look;
  QObject::connect(&look, &QTimer::timeout, &loop, [&] {
    if (done() || double(clock.elapsed()) > timeout_s_ * 1000) loop.quit();
  });
  look.start(kLookEveryMs);
  if (!done()) loop.exec();
  return done();
}

bool MapReading::local() const { return session_.robot().address().startsWith(QLatin1String("file:")); }

CommandFailure MapReading::failure(int exit_code, const QString& sentence) const {
  return {exit_code, QStringLiteral("%1: %2").arg(oneLine(address_, kLongestAddress), sentence)};
}

CommandResult<std::unique_ptr<MapReading>> MapReading::open(const QString& address, const QByteArray& secret,
                                                            double timeout_s) {
  if (address.isEmpty()) {
    return tl::make_unexpected(CommandFailure{
        kUsage,
        QStringLiteral("Which robot? Give --robot ADDRESS or set MAPWRIGHT_ROBOT; a file works too.")});
  }
  auto robot = makeRobot(address, secret, DemoTime::Frozen);
  if (!robot) return tl::make_unexpected(CommandFailure{kUsage, robot.error()});
  std::unique_ptr<MapReading> reading(new MapReading(std::move(*robot), address, timeout_s));
  session::Session& session = reading->session_;
  session.open();
  const auto phase = [&] { return session.connection().phase; };
  reading->waitUntil([&] {
    return phase() == robot::ConnectionPhase::Online || phase() == robot::ConnectionPhase::Refused ||
           (phase() == robot::ConnectionPhase::Interrupted &&
            session.connection().attempt >= kConnectAttempts);
  });
  if (phase() != robot::ConnectionPhase::Online) {
    const bool file = reading->local() && phase() == robot::ConnectionPhase::Refused;
    const QString reason = session.connection().reason;
    return tl::make_unexpected(reading->failure(
        file ? kUsage : kUnreachable,
        reason.isEmpty() ? QStringLiteral("no connection within %1 s.").arg(timeout_s) : reason));
  }
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
        failure(kRobotError, QStringLiteral("It did not answer within %1 s.").arg(timeout_s_)));
  }
  if (!catalogue.error().isEmpty()) {
    return tl::make_unexpected(failure(local() ? kUsage : kRobotError, catalogue.error()));
  }
  warnOfProblems();
  return &catalogue.entries();
}

void MapReading::warnOfProblems() {
  for (const session::LoggedProblem& row : session_.problems().rows()) {
    if (row.resolved || row.problem.severity == map::Severity::Info) continue;
    // What concerns the robot as such, or a submap list that has not come yet, is not what was asked for.
    const map::SubjectKind kind = row.problem.subject.kind;
    if (kind == map::SubjectKind::Robot) continue;
    if (kind == map::SubjectKind::SubmapList && row.problem.code == map::ProblemCode::Unavailable) continue;
    if (row.problem.severity == map::Severity::Error) complete_ = false;
    const QString line =
        text(map::toText(row.problem.subject)) + QStringLiteral(": ") + text(row.problem.sentence);
    if (warned_.insert(line).second) std::fprintf(stderr, "%s\n", qUtf8Printable(oneLine(line)));
  }
}

CommandResult<render::PlacedGrid> MapReading::map(const QString& id, double resolution_m) {
  if (id == QLatin1String("submaps")) return submaps(resolution_m);
  session::MapSlot& slot = session_.wholeMap();
  const bool sends_maps = session_.robot().liveTopics() != nullptr;
  using Phase = session::MapSlot::Phase;
  if (!id.isEmpty() && id != QLatin1String("live") && id != QLatin1String("file")) {
    const auto rows = catalogue();  // for the map's name, and to tell a wrong id from a broken map
    if (!rows) return tl::make_unexpected(rows.error());
    const map::CatalogueEntry* const entry = session_.catalogue().called(id.toStdString());
    session_.openMap(entry ? entry->key : map::mapKeyFromText(id.toStdString()));
  } else if (sends_maps) {
    session_.want(QStringLiteral("command"), scene::layerTopics(scene::Layer::WholeMap));
    session_.openMap({map::MapKind::Live, {}});
    QElapsedTimer clock;
    clock.start();
    waitUntil(
        [&] { return slot.phase() != Phase::Fetching || double(clock.elapsed()) > kLiveMapWithinS * 1000; });
    if (slot.phase() == Phase::Fetching) {
      const auto rows = catalogue();
      const map::CatalogueEntry* const current = rows ? session_.catalogue().current() : nullptr;
      if (!current || id == QLatin1String("live")) {
        return tl::make_unexpected(failure(kRobotError, QStringLiteral("It sends no map now.")));
      }
      session_.openMap(current->key);
    }
  } else {
    const auto rows = catalogue();
    if (!rows) return tl::make_unexpected(rows.error());
    const map::CatalogueEntry* entry = session_.catalogue().current();
    if (!entry && (*rows)->size() == 1) entry = &(*rows)->front();
    if (!entry) {
      return tl::make_unexpected(failure(
          kRobotError,
          (*rows)->empty()
              ? QStringLiteral("There is no map.")
              : QStringLiteral("None of its %1 maps is the current one: give an id.").arg((*rows)->size())));
    }
    if (!(slot.key() == entry->key) || slot.phase() == Phase::Empty) session_.openMap(entry->key);
  }
  if (!waitUntil(
          [&] { return slot.settled() && slot.phase() != Phase::Empty && !slot.waypointsAwaited(); })) {
    return tl::make_unexpected(
        failure(kRobotError, QStringLiteral("The map had not arrived within %1 s.").arg(timeout_s_)));
  }
  name_ = slot.name();
  if (slot.phase() == Phase::Failed || !slot.cells()) {
    return tl::make_unexpected(failure(local() ? kUsage : kRobotError, slot.remark()));
  }
  warnOfProblems();
  return render::PlacedGrid{slot.cells(), slot.reference()};
}

CommandResult<render::PlacedGrid> MapReading::submaps(double resolution_m) {
  if (!session_.robot().submapSource()) {
    return tl::make_unexpected(failure(kRobotError, QStringLiteral("This robot has no submaps.")));
  }
  const bool settled = waitUntil([&] { return session_.settled(kTries); });
  warnOfProblems();
  if (!settled) {
    std::fprintf(stderr, "Not every submap had arrived within %g s; the others are exported.\n", timeout_s_);
  }
  std::vector<render::PlacedTexture> textures;
  for (const auto& [id, row] : session_.book().rows()) {
    if (const auto placement = session_.book().placement(id, session_.slice())) {
      textures.push_back({id, placement->texture, placement->world_from_texture, 0});
    }
  }
  render::DenseCache cache(std::size_t(256) << 20);
  auto made = render::composeGrid(textures, resolution_m, cache);
  if (!made) return tl::make_unexpected(failure(kRobotError, QString::fromStdString(made.error())));
  return render::PlacedGrid{made->cells, made->reference};
}

}  // namespace mapwright::app
