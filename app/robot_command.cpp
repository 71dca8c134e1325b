#include "app/robot_command.h"

#include <algorithm>
#include <cstdio>

#include <QDeadlineTimer>
#include <QEventLoop>
#include <QJsonArray>
#include <QTimer>

#include "app/bag_reading.h"
#include "app/command_map.h"
#include "app/command_text.h"
#include "app/display.h"
#include "app/map_request.h"
#include "app/output.h"
#include "app/robot_factory.h"
#include "grids/grid_pyramid.h"
#include "incident/report.h"
#include "regions/map_regions.h"
#include "render/compose_grid.h"
#include "render/dense_cache.h"
#include "replay/replay_robot.h"
#include "robot/address.h"
#include "robot/map_dispatch.h"
#include "sentences/absence_sentence.h"
#include "sentences/failure_sentence.h"
#include "sentences/fault_sentence.h"
#include "session/session_options.h"
#include "session/submaps_complete.h"
#include "submap/submap_store.h"
#include "ui/scene/layer.h"
#include "ui/shot/recall.h"
#include "words/listed.h"
#include "words/text.h"
#include "work/budgets.h"

namespace mapwright::app {
namespace {

constexpr int kMapLookEveryMs = 10;
constexpr int kMapConnectAttempts = 3;
constexpr int kMapTries = 3;
constexpr int kMapFarewellMs = 200;  // how long to wait for the result of a change that was given up

double secondsSince(SteadyTime start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Requests only what the command shows.
session::Session::Options quietOptions(RobotReading::Purpose purpose,
                                       const std::shared_ptr<work::Workers>& workers) {
  session::Session::Options options = sessionOptions();
  options.workers = workers;
  options.overview = options.maps = false;
  options.basics = {purpose == RobotReading::Purpose::Submaps, false, false};
  return options;
}

constexpr double kRoundingCells = 2;

QString lengths(const geometry::WorldRect& rect) {
  return Text::tr("%1 × %2").arg(rect.width(), 0, 'f', 2).arg(rect.height(), 0, 'f', 2);
}

/// The first row of a part is the lowest, that of a pyramid the uppermost. -1 is 255 in both.
std::shared_ptr<const grids::GridPyramid> pyramidOf(const map::GridPart& part,
                                                    const std::shared_ptr<work::Workers>& workers) {
  const auto builder = grids::buildGrid(part.grid.width, part.grid.height, grids::CellCode::Occupancy,
                                        grids::Reduction::OccupiedWins, {workers, nullptr});
  const auto width = std::size_t(part.grid.width);
  for (std::size_t row = std::size_t(part.grid.height); row-- > 0;) {
    const auto* const cells = reinterpret_cast<const std::uint8_t*>(part.cells->data() + row * width);
    builder->pushRow({cells, width});
  }
  builder->finish();
  return builder->pyramid();
}

QJsonObject failed(const QString& sentence) {
  return {{QStringLiteral("complete"), false}, {QStringLiteral("warnings"), QJsonArray{sentence}}};
}

}  // namespace

bool CommandTime::over(double grace_s) const { return secondsSince(start.begun) > timeout_s + grace_s; }

RobotReading::RobotReading(std::unique_ptr<robot::Robot> robot, QString address, CommandTime time,
                           Purpose purpose, std::shared_ptr<work::Workers> workers)
    : workers_(std::move(workers)),
      session_(std::move(robot), quietOptions(purpose, workers_)),
      address_(std::move(address)),
      time_(time) {}

bool RobotReading::waitUntil(const std::function<bool()>& done, double at_most_s) {
  const QDeadlineTimer deadline(at_most_s < 1e6 ? qint64(at_most_s * 1000) : -1, Qt::PreciseTimer);
  // Looks after everything that happens; the timer is for what happens without an event.
  QTimer look;
  look.start(kMapLookEveryMs);
  QEventLoop loop;
  while (!done()) {
    if (time_.over() || deadline.hasExpired()) return false;
    loop.processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
  }
  return true;
}

bool RobotReading::local() const { return session_.robot().isLocal(); }

std::vector<std::string> RobotReading::sourceFiles() const {
  const session::MapSlot& slot = session_.wholeMap();
  return sourceFilesOf(address_, slot.key().id, slot.shown().path);
}

QString RobotReading::about(const QString& sentence) const {
  constexpr qsizetype kLongestAddress = 200;
  return words::about(oneLine(address_, kLongestAddress), sentence);
}

tl::unexpected<CommandFailure> RobotReading::failure(int exit_code, const QString& sentence) const {
  return tl::make_unexpected(CommandFailure{exit_code, about(sentence)});
}

int RobotReading::exitCodeHere(const map::Failure& failed) const {
  // Files do not answer: they cannot be read or written.
  const bool of_file =
      local() && failed.kind != map::FailureKind::Conflict && failed.kind != map::FailureKind::TimedOut;
  return of_file ? int(kUsage) : int(exitCodeOf(failed));
}

tl::unexpected<CommandFailure> RobotReading::failure(const map::Failure& failed) const {
  return failure(exitCodeHere(failed), QString::fromStdString(sentences::sentenceOf(failed)));
}

void RobotReading::giveUp(const robot::Call& call, const std::function<bool()>& over) const {
  call.cancel();
  QEventLoop loop;
  const QDeadlineTimer farewell(kMapFarewellMs);
  while (!over() && !farewell.hasExpired()) loop.processEvents(QEventLoop::AllEvents, kMapLookEveryMs);
}

map::Failure RobotReading::tooLate(map::Failure failure) const {
  failure.kind = map::FailureKind::TimedOut;
  failure.detail = Text::tr("it did not answer within %1 s").arg(time_.timeout_s).toStdString();
  return failure;
}

void RobotReading::warnOfUnconfirmed(robot::Capability capability) {
  unconfirmed_ = sentences::unconfirmedOf(session_.robot(), capability);
  if (!unconfirmed_.isEmpty()) addRemark(about(unconfirmed_));
}

void RobotReading::await(robot::Capability capability) {
  waitUntil([&] {
    return session_.robot().unavailableReason(capability).reason != robot::Absence::Reason::NotToldYet;
  });
}

tl::unexpected<CommandFailure> RobotReading::lacks(robot::Capability capability) const {
  const robot::Absence absence = session_.robot().unavailableReason(capability);
  if (absence.reason == robot::Absence::Reason::NotToldYet)
    return failure(exitCodeOf(map::FailureKind::TimedOut),
                   Text::tr("The robot has not answered within %1 s whether it can be edited. Nothing was "
                            "changed: try again, or wait longer (--timeout).")
                       .arg(time_.timeout_s));
  return failure(local() ? kUsage : kRobotError, sentences::absenceReason(capability, absence));
}

CommandResult<std::unique_ptr<RobotReading>> RobotReading::open(const QString& address, const Access& access,
                                                                CommandTime time, Purpose purpose,
                                                                std::shared_ptr<work::Workers> workers,
                                                                const std::string& bag) {
  if (address.isEmpty()) {
    return wrong(Text::tr("Which robot? Pass --robot ADDRESS or set MAPWRIGHT_ROBOT; a file works too."));
  }
  if (purpose == Purpose::Submaps) {
    if (const auto why = recordingWithoutTimeReason(address, bag)) return wrong(*why);
  }
  Access timed = access;
  timed.timeout = std::chrono::milliseconds(qint64(time.timeout_s * 1000));
  auto robot = makeRobot(address, timed, DemoTime::Frozen);
  if (!robot) return wrong(robot.error());
  if (!bag.empty()) *robot = std::make_unique<replay::ReplayRobot>(std::move(*robot), bag);
  std::unique_ptr<RobotReading> reading(
      new RobotReading(std::move(*robot), address, time, purpose, std::move(workers)));
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
    const QString reason = notConnectedReason(session.connection());
    return reading->failure(
        file ? kUsage : exitCodeOf(session.connection().failure, kUnreachable),
        reason.isEmpty() ? Text::tr("no connection within %1 s.").arg(time.timeout_s) : reason);
  }
  reading->online_since_ = std::chrono::steady_clock::now();
  return reading;
}

CommandResult<map::CatalogueEntry> RobotReading::change(const robot::MapOrder& order) {
  robot::MapAdministration* const maps = session_.robot().mapAdministration();
  if (!maps) return lacks(robot::Capability::Administration);
  const auto obstacle = maps->obstacle(order.change, nullptr);
  if (obstacle == robot::Obstacle::NotOffered || obstacle == robot::Obstacle::EndsBySaving) {
    return failure(local() ? kUsage : kRobotError, sentences::notNowReason(order.change, *obstacle));
  }
  warnOfUnconfirmed(robot::Capability::Administration);
  auto outcome = ask<map::CatalogueEntry>(
      [&](robot::OutcomeTo<map::CatalogueEntry> reply) { return maps->carryOut(order, std::move(reply)); });
  if (outcome) return std::move(*outcome);
  outcome.error().asked_for = map::AskedFor::Change;
  return failure(outcome.error());
}

CommandResult<const std::vector<map::CatalogueEntry>*> RobotReading::catalogue() {
  session::Catalogue& catalogue = session_.catalogue();
  if (!catalogue.offered()) {
    return lacks(robot::Capability::Catalogue);
  }
  if (!catalogue.asOf() && !catalogue.loading()) catalogue.refresh();
  if (!waitUntil([&] { return !catalogue.loading() && (catalogue.asOf() || catalogue.failure()); })) {
    return failure(exitCodeOf(map::FailureKind::TimedOut),
                   Text::tr("It did not answer within %1 s.").arg(time_.timeout_s));
  }
  if (catalogue.failure()) {
    return failure(local() ? kUsage : exitCodeOf(catalogue.failure()->kind),
                   QString::fromStdString(sentences::sentenceOf(*catalogue.failure())));
  }
  // An incomplete list is a problem of its own.
  insistOnAll();
  return &catalogue.entries();
}

QStringList RobotReading::problems(map::Severity least) const {
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

void RobotReading::insistOnReadable() {
  for (const session::LoggedProblem& row : session_.problems().rows()) {
    const bool unreadable =
        row.problem.code == map::ProblemCode::Unreadable && row.problem.severity >= map::Severity::Warning;
    if (!row.resolved && unreadable) complete_ = false;
  }
}

QStringList RobotReading::warnings() const {
  QStringList all = bagLosses(session_.problems()) + lacks_ + problems(map::Severity::Error) + notes_ +
                    problems(map::Severity::Warning);
  all.removeDuplicates();  // problems of waypoints are found again when their map is opened
  return all;
}

QJsonObject RobotReading::facts() const {
  QJsonObject facts = trafficJson(session_.counts());
  for (auto it = facts_.begin(); it != facts_.end(); ++it) facts[it.key()] = it.value();
  return facts;
}

CommandResult<render::PlacedGrid> RobotReading::map(const QString& id, double resolution_m) {
  if (id == QLatin1String("submaps")) return submaps(resolution_m);
  // Before anything is requested.
  if (!id.isEmpty() && !local() && id != QLatin1String("live") &&
      !isPlainId(map::mapKeyFromText(id.toStdString()).id))
    return failure(kUsage, Text::tr("%1: pass the id of a map (see mapwright maps list).").arg(oneLine(id)));
  if (id.isEmpty() || id == QLatin1String("live")) {
    session_.want(QStringLiteral("command"), ui::scene::layerStreams(ui::scene::Layer::WholeMap));
  }
  MapRequest request(session_, id, true);
  request.agreeToWhole();
  const bool in =
      waitUntil([&] { return request.look(secondsSince(online_since_)) != MapRequest::State::Waiting; });
  if (!in) {
    const QString late = Text::tr("The map had not arrived within %1 s.").arg(time_.timeout_s);
    return failure(exitCodeOf(map::FailureKind::TimedOut),
                   words::paragraph(QStringList(late) + request.liveTroubles().mid(0, 1)));
  }
  if (request.look(secondsSince(online_since_)) == MapRequest::State::Failed) {
    return failure(request.failure().exit_code, request.failure().sentence);
  }
  session_.standStill();
  complete_ = complete_ && request.complete() && problems(map::Severity::Error).isEmpty();
  notes_ += request.notes();
  name_ = session_.wholeMap().name();
  const render::PlacedGrid grid = *request.grid();
  facts_[QStringLiteral("map")] = mapJson(*request.key(), name_, grid.reference);
  return grid;
}

std::optional<CommandFailure> RobotReading::recall(const std::string& at) {
  auto* const replayed = qobject_cast<replay::ReplayRobot*>(&session_.robot());
  const robot::BagInfo& bag = *replayed->reading()->info();
  const auto at_s = timeFrom(at, QStringLiteral("--at"), bag);
  if (!at_s) return at_s.error();
  const QString outside = incident::notWithinReason(replayed->bag(), bag, *at_s, !local());
  if (!outside.isEmpty()) return CommandFailure{kUsage, outside};
  ui::shot::Recall recall(session_, *replayed);
  recall.goTo(*at_s);
  const bool in_time = waitUntil([&] { return recall.in() || recall.failure(); });
  if (const auto failed = recall.failure()) return failure(*failed).value();
  if (!in_time)
    return CommandFailure{
        kIncomplete,
        about(Text::tr("Not everything had arrived within %1 s (--timeout).").arg(time_.timeout_s))};
  return std::nullopt;
}

CommandResult<std::vector<render::PlacedTexture>> RobotReading::submapTextures() {
  if (!session_.robot().submapSource()) {
    return lacks(robot::Capability::Submaps);
  }
  const bool settled = waitUntil([&] { return session_.settled(kMapTries); });
  session_.standStill();
  session_.close();
  const session::SubmapCounts counts = session_.counts();
  complete_ = complete_ && settled && session::submapsComplete(counts, session_.problems());
  facts_[QStringLiteral("submaps")] = submapsJson(counts);
  facts_[QStringLiteral("uuid")] = QString::fromStdString(session_.submaps().uuid());
  if (!settled) {
    lacks_ << (counts.list_received ? Text::tr("Not everything had arrived within %1 s (--timeout).")
               : session::listUnreadable(session_.problems())
                   ? Text::tr("The robot sent no readable submap list within %1 s (--timeout).")
                   : Text::tr("The robot sent no submap list within %1 s (--timeout)."))
                  .arg(time_.timeout_s);
  }
  std::vector<render::PlacedTexture> textures;
  for (const auto& [id, row] : session_.submaps().rows()) {
    if (const auto placement = session_.submaps().placement(id, session_.slice())) {
      textures.push_back({id, placement->texture, placement->world_from_texture, 0});
    }
  }
  if (textures.empty()) {
    // A snapshot would be empty, but there is no grid of no size, and nothing to compare.
    const QStringList why = refused() ? problems(map::Severity::Error) : warnings();
    return failure(complete_   ? int(kRobotError)
                   : refused() ? exitCodeOf(map::FailureKind::Refused)
                               : int(kIncomplete),
                   counts.listed == 0 && settled && complete_ ? Text::tr("It has no submaps yet.")
                   : counts.listed > 0 && counts.without_slice == counts.listed
                       ? Text::tr("None of its submaps has a slice %1.").arg(session_.slice())
                       : Text::tr("None of its submaps could be loaded. %1").arg(firstOf(why)));
  }
  return textures;
}

CommandResult<render::PlacedGrid> RobotReading::submaps(double resolution_m) {
  const auto textures = submapTextures();
  if (!textures) return passOn(textures);
  const session::SubmapCounts counts = session_.counts();
  render::DenseCache cache(work::budgetsFrom().dense + work::budgetsFrom().tiles);  // no tiles are kept
  bool in_time = true;
  auto made = render::composeGrid(*textures, resolution_m, cache,
                                  [&](double) {
                                    in_time = !time_.over(time_.start.grace.draw_s);
                                    return in_time;
                                  },
                                  {workers_});
  if (!in_time) {
    return failure(
        kIncomplete,
        Text::tr("%1 of %2 submaps had arrived, but drawing them took longer than %3 s (--timeout).")
            .arg(counts.shown)
            .arg(counts.listed)
            .arg(time_.timeout_s));
  }
  if (!made) return failure(kRobotError, sentences::wordsOf(made.error()));
  return render::PlacedGrid{made->cells, made->reference};
}

CommandResult<render::PlacedGrid> RobotReading::part(const std::optional<map::GridRegion>& region) {
  robot::MapDispatch* const dispatch = session_.robot().mapDispatch();
  if (!dispatch) return lacks(robot::Capability::Dispatch);
  const auto part = ask<map::GridPart>(
      [&](robot::OutcomeTo<map::GridPart> reply) { return dispatch->grid(region, std::move(reply)); });
  if (!part) return failure(part.error());
  for (const Fault& note : part->notes) notes_ << about(sentences::wordsOf(note));
  if (part->grid.width == 0) {
    return failure(kIncomplete,
                   region ? Text::tr("Its map is empty in this region.") : Text::tr("Its map is empty."));
  }
  if (part->grid.width > grids::kMaxGridEdge || part->grid.height > grids::kMaxGridEdge)
    return failure(kRobotError, Text::tr("Its answer has too many cells in a row."));
  const geometry::WorldRect bounds = part->grid.bounds();
  if (region) {
    const Eigen::Vector2d low = region->centre_m - region->size_m / 2,
                          high = region->centre_m + region->size_m / 2;
    const geometry::WorldRect asked{low.x(), low.y(), high.x(), high.y()};
    const geometry::WorldRect common = regions::commonGround(part->grid, asked);
    const double rounding = kRoundingCells * part->grid.resolution_m;
    if (regions::liesElsewhere(part->grid, asked)) {
      lack(about(Text::tr("It answered with another part of its map, around %1 m, %2 m.")
                     .arg(bounds.center().x(), 0, 'f', 2)
                     .arg(bounds.center().y(), 0, 'f', 2)));
    } else if (part->grid.origin.yaw_rad == 0 &&
               (common.width() < asked.width() - rounding || common.height() < asked.height() - rounding)) {
      notes_ << about(Text::tr("Its answer covers %1 of the %2 m requested: either its map "
                               "ends there, or it does not send more at once.")
                          .arg(lengths(common), lengths(asked)));
    }
  }
  const auto offers = dispatch->offers();
  const auto service = region ? robot::DispatchService::GridRegion : robot::DispatchService::Grid;
  for (const robot::DispatchOffer& offer : offers) {
    if (offer.service == service) name_ = QString::fromStdString(offer.name);
  }
  facts_[QStringLiteral("map")] = mapJson({map::MapKind::Live, {}}, name_, part->grid);
  return render::PlacedGrid{pyramidOf(*part, workers_), part->grid};
}

RobotCommand::RobotCommand(const RobotArguments& args)
    : args_(args),
      time_{commandStart(args.timeout_s, processAge()), args.timeout_s},
      report_path_(words::text(args.report)) {}

CommandResult<RobotReading*> RobotCommand::open(RobotReading::Purpose purpose, const QString& other,
                                                const std::string& bag) {
  const QString robot = words::text(args_.robot), address = other.isEmpty() ? robot : other;
  const auto access = RobotAccess::read(args_.access, robot);
  if (!access) return wrong(access.error());
  auto reading = RobotReading::open(address, access->forAddress(address), time_, purpose, workers_, bag);
  if (!reading) return passOn(reading);
  reportConnected();
  readings_.push_back(std::move(*reading));
  return readings_.back().get();
}

bool RobotCommand::complete() const {
  for (const auto& reading : readings_) {
    if (!reading->complete()) return false;
  }
  return true;
}

QStringList RobotCommand::warnings() const {
  QStringList all;
  for (const auto& reading : readings_) all += reading->warnings();
  return all;
}

int RobotCommand::run(int& argc, char** argv, const std::function<CommandResult<int>(RobotCommand&)>& work) {
  if (const auto why = noTimeoutReason(time_.timeout_s)) return refuse(kUsage, *why);
  const QString robot = words::text(args_.robot);
  if (const auto why = reportOverSource(report_path_, sourceFilesOf(robot, {}, {})))
    return refuse(kUsage, *why);
  if (isStandardOutput(report_path_)) leaveStandardOutputToReport();
  Deadline deadline(
      later(time_.start.begun, time_.timeout_s + time_.start.grace.end_s),
      [connected = connected_, late = late_, path = report_path_, timeout_s = time_.timeout_s,
       robot = oneLine(robot)] {
        const QString sentence =
            *connected
                ? Text::tr("Incomplete: the command did not finish within %1 s (--timeout).").arg(timeout_s)
                : Text::tr("%1: no connection within %2 s (--timeout).")
                      .arg(robot, QString::number(timeout_s));
        if (!path.isEmpty()) writeReportInHaste(path, failed(sentence));
        sayAtTheEnd(sentence.toStdString());
        return *connected ? late->load() : int(kUnreachable);
      });
  OffscreenApplication application(argc, argv);
  const int exit_code = end(work(*this));
  std::fflush(stdout);
  // Everything has been reported: cleaning up must not take longer than the remaining time.
  deadline.setLastWords([exit_code] { return exit_code; });
  readings_.clear();
  return exit_code;
}

int RobotCommand::end(CommandResult<int> result) const {
  for (const auto& reading : readings_) {
    if (!result)
      result.error().sentence = words::paragraph({result.error().sentence, reading->unconfirmed()});
  }
  const QStringList warnings = this->warnings();
  QJsonObject report;
  if (!result) {
    report = failed(result.error().sentence);
  } else {
    if (readings_.size() == 1) report = readings_.front()->facts();
    if (readings_.size() == 2) {
      report[QStringLiteral("first")] = readings_.front()->facts();
      report[QStringLiteral("second")] = readings_.back()->facts();
    }
    report[QStringLiteral("complete")] = complete();
    report[QStringLiteral("warnings")] = QJsonArray::fromStringList(warnings);
  }
  if (!done_.isEmpty()) report[done_name_] = done_;
  for (const auto& reading : readings_) {
    // The work is done by now, or has failed.
    if (const auto why = reportOverSource(report_path_, reading->sourceFiles()))
      return refuse(!result           ? result.error().exit_code
                    : done_.isEmpty() ? int(kUsage)
                                      : int(kIncomplete),
                    result ? *why : result.error().sentence);
  }
  if (!report_path_.isEmpty() && (result || result.error().reported)) {
    if (const auto problem = writeReport(report_path_, report)) return refuse(kUsage, *problem);
  }
  if (!result) return refuse(result.error().exit_code, result.error().sentence);
  if (!complete()) {
    const bool refused = std::any_of(readings_.begin(), readings_.end(),
                                     [](const auto& reading) { return reading->refused(); });
    return refuse(refused            ? exitCodeOf(map::FailureKind::Refused)
                  : *result == kDone ? int(kIncomplete)
                                     : *result,
                  Text::tr("Incomplete. %1").arg(firstOf(warnings)));
  }
  return warnings.isEmpty() ? *result : refuse(*result, firstOf(warnings));
}

}  // namespace mapwright::app
