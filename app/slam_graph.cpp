// `mapwright slam info|closures`: what a state file of Cartographer holds, and which constraints contradict
// the finished map (docs/command-line.md, "mapwright slam").
#include <algorithm>
#include <cmath>
#include <set>

#include <CLI/CLI.hpp>
#include <QDateTime>
#include <QJsonArray>
#include <QJsonObject>

#include "app/bag_reading.h"
#include "app/command_text.h"
#include "app/output.h"
#include "app/robot_command.h"
#include "app/robot_factory.h"
#include "geometry/rect.h"
#include "map/closures.h"
#include "pbstream/submap_texture.h"
#include "robot/pose_graph_source.h"
#include "sentences/fault_sentence.h"
#include "words/figures.h"
#include "words/fixed.h"
#include "words/listed.h"
#include "words/qt_versions.h"
#include "words/text.h"
#include "work/workers.h"

namespace mapwright::app {
namespace {

using words::text;

constexpr int kTableRows = 20;

struct SlamArguments : RobotArguments {};

QJsonArray pointJson(const Eigen::Vector2d& at) { return {at.x(), at.y()}; }
QJsonValue orNull(std::optional<double> value) { return value ? QJsonValue(*value) : QJsonValue(); }
QString counted(std::size_t count) { return QString::fromStdString(words::grouped(std::int64_t(count))); }

QString timeText(std::optional<double> stamp_s) {
  if (!stamp_s) return QStringLiteral("-");
  return words::utcOfMs(qint64(std::llround(*stamp_s * 1000)))
      .toString(QStringLiteral("yyyy-MM-dd HH:mm:ss"));
}

/// The state file that `address` names, read as a whole; the sentence says why not.
CommandResult<pbstream::StateFile> stateFileAt(const RobotArguments& args, const CommandTime& time) {
  const QString address = text(args.robot);
  if (address.isEmpty())
    return wrong(Text::tr("Which file? Pass --robot FILE.pbstream or set MAPWRIGHT_ROBOT."));
  const auto path = stateFileOf(address);
  if (!path)
    return wrong(
        Text::tr("%1: this needs a Cartographer state file (.pbstream).").arg(oneLine(address, 200)));
  auto read = pbstream::readStateFile(path->toStdString(), [&] { return time.over(); });
  if (!read && time.over())
    return tl::make_unexpected(CommandFailure{
        kIncomplete,
        Text::tr("%1: reading it took longer than %2 s (--timeout).").arg(*path).arg(time.timeout_s)});
  if (!read) {
    const QString why = sentences::wordsOf(read.error());
    return wrong(why.contains(*path) ? why : words::about(*path, why));
  }
  return std::move(*read);
}

// slam info

struct TrajectoryFacts {
  std::int32_t id = 0;
  std::size_t submaps = 0, nodes = 0;
  std::optional<double> start_s, end_s;
  double length_m = 0;
};

std::vector<TrajectoryFacts> trajectoriesOf(const map::PoseGraph& graph) {
  std::vector<TrajectoryFacts> all;
  for (const map::Trajectory& trajectory : graph.trajectories) {
    TrajectoryFacts facts;
    facts.id = trajectory.id;
    facts.nodes = trajectory.nodes.size();
    facts.submaps =
        std::size_t(std::count_if(graph.submaps.begin(), graph.submaps.end(),
                                  [&](const auto& submap) { return submap.id.trajectory == trajectory.id; }));
    std::optional<Eigen::Vector3d> before;
    for (const map::TrajectoryNode& node : trajectory.nodes) {
      if (node.stamp_s) {
        facts.start_s = std::min(facts.start_s.value_or(*node.stamp_s), *node.stamp_s);
        facts.end_s = std::max(facts.end_s.value_or(*node.stamp_s), *node.stamp_s);
      }
      if (!geometry::toIsometry(node.pose)) continue;
      const Eigen::Vector3d at(node.pose.x, node.pose.y, node.pose.z);
      if (before) facts.length_m += (at - *before).norm();
      before = at;
    }
    all.push_back(facts);
  }
  return all;
}

/// Of all textures, whatever is known in them. Faults: of those that cannot be read.
geometry::WorldRect boundsOf(const pbstream::StateFile& file, std::vector<Fault>& faults) {
  std::vector<geometry::WorldRect> rects(file.submaps.size());
  std::vector<Fault> why(file.submaps.size());
  work::Tasks tasks(work::orOwn(nullptr));
  for (std::size_t i = 0; i < file.submaps.size(); ++i) {
    tasks.start(work::Urgency::Wanted, [&, i] {
      const geometry::Pose3* const pose = file.poseOf(file.submaps[i].id);
      if (!pose) return;
      const auto world = geometry::toIsometry(*pose);
      if (!world) return;
      const auto textures = pbstream::readTextures(*file.file, file.submaps[i], *pose);
      if (!textures) why[i] = textures.error();
      if (!textures) return;
      for (const map::RawSlice& slice : textures->slices) {
        const auto in_submap = geometry::toIsometry(slice.slice_pose);
        if (!in_submap) continue;
        const geometry::Pose2 placed = geometry::projectToPlane(*world * *in_submap);
        for (const double x : {0.0, -slice.resolution_m * slice.height}) {
          for (const double y : {0.0, -slice.resolution_m * slice.width})
            rects[i].extend(placed.apply({x, y}));
        }
      }
    });
  }
  tasks.waitForDone();
  geometry::WorldRect bounds;
  for (const geometry::WorldRect& rect : rects) bounds.extend(rect);
  for (Fault& fault : why) {
    if (fault.any()) faults.push_back(std::move(fault));
  }
  return bounds;
}

/// How often each cell size occurs; that of most submaps.
std::optional<double> resolutionOf(const pbstream::StateFile& file) {
  std::map<double, int> sizes;
  for (const pbstream::StoredSubmap& submap : file.submaps) {
    const double size_m = submap.resolution_m.value_or(NAN);
    if (std::isfinite(size_m) && size_m > 0) ++sizes[size_m];
  }
  const auto most = std::max_element(sizes.begin(), sizes.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == sizes.end() ? std::nullopt : std::optional(most->first);
}

/// A sentence about submaps whose place in the pose graph is none; empty: there are none.
QString unplaceableIn(const pbstream::StateFile& file) {
  constexpr qsizetype kMostNamed = 5;
  QStringList names;
  for (const pbstream::StoredSubmap& submap : file.submaps) {
    const geometry::Pose3* const pose = file.poseOf(submap.id);
    if (pose && !geometry::toIsometry(*pose)) names << text(map::toText(submap.id));
  }
  if (names.isEmpty()) return {};
  const QString count = counted(std::size_t(names.size()));
  if (names.size() > kMostNamed) names = names.mid(0, kMostNamed) << QStringLiteral("…");
  return Text::tr("Submaps whose place is none, as a number is not finite or it has no direction: %1 (%2).")
      .arg(count, words::listed(names));
}

QString noLoopClosed() {
  return Text::tr("No loop was closed: this map is odometry and scan matching only.");
}

CommandResult<int> slamInfo(RobotCommand& command, const SlamArguments& args) {
  command.reportConnected();
  const auto file = stateFileAt(args, command.time());
  if (!file) return passOn(file);
  const map::Closures closures = map::rankClosures(*file->graph);
  const std::vector<TrajectoryFacts> trajectories = trajectoriesOf(*file->graph);
  std::vector<Fault> losses = file->losses();
  const geometry::WorldRect bounds = boundsOf(*file, losses);
  QStringList warnings, odd;
  for (const Fault& loss : losses) warnings << sentences::wordsOf(loss);
  if (const QString unplaceable = unplaceableIn(*file); !unplaceable.isEmpty()) warnings << unplaceable;
  const auto unfinished = std::size_t(std::count_if(file->submaps.begin(), file->submaps.end(),
                                                    [](const auto& submap) { return !submap.finished; }));
  std::size_t nodes = 0;
  for (const TrajectoryFacts& trajectory : trajectories) nodes += trajectory.nodes;
  if (file->nodes_without_pose > 0)
    odd << Text::tr("Nodes without a pose in the pose graph: %1.").arg(counted(file->nodes_without_pose));
  if (closures.dangling > 0)
    odd << Text::tr("Constraints that refer to submaps or nodes that are not there: %1.")
               .arg(counted(closures.dangling));
  if (closures.without_pose > 0)
    odd << Text::tr("Constraints without a usable pose: %1.").arg(counted(closures.without_pose));
  if (file->submaps.empty()) odd << Text::tr("There are no submaps in it.");
  if (closures.inter == 0 && nodes > 0) odd << noLoopClosed();
  if (file->option_lists && *file->option_lists != file->graph->trajectories.size())
    odd << Text::tr(
               "Its options are for another number of trajectories (%1) than it holds (%2): Cartographer may "
               "refuse to load it.")
               .arg(counted(*file->option_lists), counted(file->graph->trajectories.size()));
  const auto resolution = resolutionOf(*file);
  if (args.json) {
    QJsonArray of_trajectories;
    for (const TrajectoryFacts& one : trajectories) {
      of_trajectories << QJsonObject{{QStringLiteral("id"), one.id},
                                     {QStringLiteral("submaps"), qint64(one.submaps)},
                                     {QStringLiteral("nodes"), qint64(one.nodes)},
                                     {QStringLiteral("start"), orNull(one.start_s)},
                                     {QStringLiteral("end"), orNull(one.end_s)},
                                     {QStringLiteral("length_m"), one.length_m}};
    }
    QJsonObject records;
    for (std::size_t kind = 0; kind < pbstream::kRecordKinds; ++kind) {
      if (file->records[kind] > 0)
        records[QLatin1String(pbstream::nameOf(pbstream::RecordKind(kind)))] = qint64(file->records[kind]);
    }
    printJson(QJsonObject{
        {QStringLiteral("format_version"), qint64(file->format_version)},
        {QStringLiteral("submaps"), qint64(file->submaps.size())},
        {QStringLiteral("unfinished"), qint64(unfinished)},
        {QStringLiteral("nodes"), qint64(nodes)},
        {QStringLiteral("trajectories"), of_trajectories},
        {QStringLiteral("constraints"), QJsonObject{{QStringLiteral("intra"), qint64(closures.intra)},
                                                    {QStringLiteral("inter"), qint64(closures.inter)},
                                                    {QStringLiteral("dangling"), qint64(closures.dangling)}}},
        {QStringLiteral("resolution"), orNull(resolution)},
        {QStringLiteral("bounds"),
         bounds.empty() ? QJsonValue()
                        : QJsonValue(QJsonArray{bounds.min_x, bounds.min_y, bounds.max_x, bounds.max_y})},
        {QStringLiteral("records"), records},
        {QStringLiteral("warnings"), QJsonArray::fromStringList(warnings + odd)}});
  } else {
    const auto metres = [](double value) { return QString::number(value, 'f', 2); };
    std::vector<QStringList> rows{
        {Text::tr("Format version"), QString::number(file->format_version)},
        {Text::tr("Submaps"),
         Text::tr("%1, %2 of them unfinished").arg(counted(file->submaps.size()), counted(unfinished))},
        {Text::tr("Nodes"), counted(nodes)},
        {Text::tr("Constraints"),
         Text::tr("%1 INTRA, %2 INTER, %3 dangling")
             .arg(counted(closures.intra), counted(closures.inter), counted(closures.dangling))}};
    if (resolution) rows.push_back({Text::tr("Resolution"), Text::tr("%1 m per cell").arg(*resolution)});
    if (!bounds.empty())
      rows.push_back({Text::tr("Bounds"), Text::tr("x %1 to %2 m, y %3 to %4 m")
                                              .arg(metres(bounds.min_x), metres(bounds.max_x),
                                                   metres(bounds.min_y), metres(bounds.max_y))});
    for (const TrajectoryFacts& one : trajectories)
      rows.push_back({Text::tr("Trajectory %1").arg(one.id),
                      Text::tr("submaps: %1, nodes: %2, %3 m, %4 to %5")
                          .arg(counted(one.submaps), counted(one.nodes), metres(one.length_m),
                               timeText(one.start_s), timeText(one.end_s))});
    for (std::size_t kind = 0; kind < pbstream::kRecordKinds; ++kind) {
      if (file->records[kind] > 0)
        rows.push_back({Text::tr("Records"), QStringLiteral("%1 %2").arg(
                                                 QLatin1String(pbstream::nameOf(pbstream::RecordKind(kind))),
                                                 counted(file->records[kind]))});
    }
    printTable(rows);
    for (const QString& sentence : odd) printLine(sentence);
    for (const QString& sentence : warnings) say(sentence);
  }
  return warnings.isEmpty() ? kDone : kIncomplete;
}

// slam closures

struct ClosuresArguments : RobotArguments {
  std::string bag, at;
  std::string kind = "inter";
  double min_m = 0;
  std::optional<int> top;
  std::optional<double> fail_over_m;
};

struct Ranked {
  map::Closures closures;
  bool told = true;    // ids, angles and times are known
  bool mapped = true;  // there is a map at all
};

/// From what cartographer_ros draws: the segments of residuals, from where a node should lie to where it
/// lies.
Ranked rankSegments(const map::ConstraintsMessage& drawn) {
  Ranked ranked;
  ranked.told = false;
  ranked.mapped = !drawn.by_name.empty();
  std::vector<double> inter, intra;
  for (const auto& [name, segments] : drawn.by_name) {
    const QString lower = text(name).toLower();
    if (!lower.contains(QLatin1String("residual"))) continue;
    const bool is_intra = lower.contains(QLatin1String("intra"));
    for (const auto& [expected, at] : segments) {
      map::Closure closure;
      closure.kind = is_intra ? map::ConstraintKind::Intra : map::ConstraintKind::Inter;
      closure.residual_m = (at - expected).norm();
      closure.at = at;
      closure.expected = expected;
      ++(is_intra ? ranked.closures.intra : ranked.closures.inter);
      if (!std::isfinite(closure.residual_m)) {
        ++ranked.closures.without_pose;
        continue;
      }
      (is_intra ? intra : inter).push_back(closure.residual_m);
      ranked.closures.ranked.push_back(closure);
    }
  }
  ranked.closures.inter_median_m = map::medianOf(inter);
  ranked.closures.intra_median_m = map::medianOf(intra);
  std::stable_sort(ranked.closures.ranked.begin(), ranked.closures.ranked.end(),
                   [](const map::Closure& a, const map::Closure& b) { return a.residual_m > b.residual_m; });
  return ranked;
}

CommandResult<Ranked> rankedOf(RobotReading& reading, const ClosuresArguments& args) {
  session::Session& session = reading.session();
  if (robot::PoseGraphSource* const source = session.robot().poseGraphSource()) {
    using Graph = std::shared_ptr<const map::PoseGraph>;
    const auto graph =
        reading.ask<Graph>([&](robot::OutcomeTo<Graph> reply) { return source->fetch(std::move(reply)); });
    if (!graph) return reading.failure(graph.error());
    reading.insistOnAll();
    return Ranked{map::rankClosures(**graph), true, !(*graph)->trajectories.empty()};
  }
  robot::LiveTopics* const live = session.robot().liveTopics();
  if (!live || live->topicsOf(map::Stream::Constraints).isEmpty())
    return reading.lacks(robot::Capability::PoseGraph);
  session.want(QStringLiteral("command"), {map::Stream::Constraints});
  if (!args.bag.empty()) {
    if (const auto failed = reading.recall(args.at)) return tl::make_unexpected(*failed);
    if (!session.live().constraints.by_name.empty()) return rankSegments(session.live().constraints);
    return reading.failure(kRobotError, Text::tr("The bag contains no constraints up to this time."));
  }
  const auto heard = [&] { return session.heard(map::topicIndex<map::ConstraintsMessage>()).has_value(); };
  if (!reading.waitUntil(heard))
    return reading.failure(
        exitCodeOf(map::FailureKind::TimedOut),
        Text::tr("The robot sent no constraints within %1 s (--timeout).").arg(reading.time().timeout_s));
  return rankSegments(session.live().constraints);
}

QJsonObject jsonOf(const map::Closure& closure, bool told) {
  const auto known = [&](const QJsonValue& value) { return told ? value : QJsonValue(); };
  return {{QStringLiteral("submap"), known(text(map::toText(closure.submap)))},
          {QStringLiteral("node"), known(text(map::toText(closure.node)))},
          {QStringLiteral("kind"),
           closure.kind == map::ConstraintKind::Inter ? QStringLiteral("inter") : QStringLiteral("intra")},
          {QStringLiteral("residual_m"), closure.residual_m},
          {QStringLiteral("residual_deg"), known(geometry::degreesFromRadians(closure.residual_rad))},
          {QStringLiteral("at"), pointJson(closure.at)},
          {QStringLiteral("expected"), pointJson(closure.expected)},
          {QStringLiteral("stamp"), orNull(closure.stamp_s)}};
}

void printClosures(const Ranked& ranked, const std::vector<map::Closure>& shown, std::size_t among) {
  const map::Closures& all = ranked.closures;
  const auto metres = [](double value) { return QString::number(value, 'f', 3); };
  if (!shown.empty()) {
    std::vector<QStringList> table{{Text::tr("METRES"), Text::tr("DEGREES"), Text::tr("X INTRA"),
                                    Text::tr("SUBMAP"), Text::tr("NODE"), Text::tr("KIND"),
                                    Text::tr("LIES AT"), Text::tr("EXPECTED AT"), Text::tr("TIME (UTC)")}};
    const auto place = [](const Eigen::Vector2d& at) {
      return QStringLiteral("%1,%2").arg(at.x(), 0, 'f', 2).arg(at.y(), 0, 'f', 2);
    };
    const QString unknown = QStringLiteral("-");
    for (const map::Closure& one : shown) {
      const bool comparable = all.intra_median_m && *all.intra_median_m > 0;
      table.push_back(
          {metres(one.residual_m),
           ranked.told ? QString::number(geometry::degreesFromRadians(one.residual_rad), 'f', 2) : unknown,
           comparable ? QString::number(one.residual_m / *all.intra_median_m, 'f', 1) : unknown,
           ranked.told ? text(map::toText(one.submap)) : unknown,
           ranked.told ? text(map::toText(one.node)) : unknown,
           one.kind == map::ConstraintKind::Inter ? QStringLiteral("INTER") : QStringLiteral("INTRA"),
           place(one.at), place(one.expected), timeText(one.stamp_s)});
    }
    printTable(table);
  }
  if (among > shown.size())
    printLine(Text::tr("%1 more (--top 0 lists all).").arg(counted(among - shown.size())));
  const auto median = [&](std::optional<double> m) {
    return m ? metres(*m) + QStringLiteral(" m") : QStringLiteral("-");
  };
  printLine(Text::tr("%1 INTER (median %2), %3 INTRA (median %4), %5 dangling")
                .arg(counted(all.inter), median(all.inter_median_m), counted(all.intra),
                     median(all.intra_median_m), ranked.told ? counted(all.dangling) : QStringLiteral("-")));
}

CommandResult<int> slamClosures(RobotCommand& command, const ClosuresArguments& args) {
  if (args.min_m < 0 || args.fail_over_m.value_or(0) < 0)
    return wrong(Text::tr("--min and --fail-over are metres, 0 or more."));
  if (args.top.value_or(0) < 0) return wrong(Text::tr("--top is a number of rows; 0 lists all."));
  if (args.bag.empty() != args.at.empty()) return wrong(Text::tr("--bag and --at belong together."));
  const auto opened = command.open(RobotReading::Purpose::Submaps, {}, args.bag);
  if (!opened) return passOn(opened);
  RobotReading& reading = **opened;
  const auto ranked = rankedOf(reading, args);
  if (!ranked) return passOn(ranked);
  const map::Closures& all = ranked->closures;
  std::vector<map::Closure> wanted;
  for (const map::Closure& closure : all.ranked) {
    const bool inter = closure.kind == map::ConstraintKind::Inter;
    if (args.kind == "all" || (args.kind == "inter") == inter) wanted.push_back(closure);
  }
  const double largest_m = wanted.empty() ? 0 : wanted.front().residual_m;
  const bool too_large = args.fail_over_m && largest_m > *args.fail_over_m;
  const auto over = std::size_t(std::count_if(wanted.begin(), wanted.end(), [&](const map::Closure& closure) {
    return closure.residual_m > args.fail_over_m.value_or(0);
  }));
  std::erase_if(wanted, [&](const map::Closure& closure) { return closure.residual_m < args.min_m; });
  const std::size_t among = wanted.size();
  const int top = args.top.value_or(args.json ? 0 : kTableRows);
  if (top > 0 && wanted.size() > std::size_t(top)) wanted.resize(std::size_t(top));
  if (!ranked->told)
    reading.addRemark(reading.about(Text::tr(
        "This robot only draws its constraints: which submaps and nodes they connect, degrees, times, and "
        "whether any are dangling is not known.")));
  if (all.without_pose > 0)
    reading.lack(reading.about(Text::tr("Constraints without a usable pose, which are not ranked: %1.")
                                   .arg(counted(all.without_pose))));
  if (all.inter == 0 && ranked->mapped) {
    if (args.json)
      reading.addRemark(noLoopClosed());
    else
      printLine(noLoopClosed());
  }
  if (args.json) {
    QJsonArray closures;
    for (const map::Closure& closure : wanted) closures << jsonOf(closure, ranked->told);
    printJson(QJsonObject{
        {QStringLiteral("inter"), qint64(all.inter)},
        {QStringLiteral("intra"), qint64(all.intra)},
        {QStringLiteral("dangling"), ranked->told ? QJsonValue(qint64(all.dangling)) : QJsonValue()},
        {QStringLiteral("without_pose"), qint64(all.without_pose)},
        {QStringLiteral("inter_median_m"), orNull(all.inter_median_m)},
        {QStringLiteral("intra_median_m"), orNull(all.intra_median_m)},
        {QStringLiteral("closures"), closures}});
  } else {
    printClosures(*ranked, wanted, among);
  }
  if (!too_large) return kDone;
  say(Text::tr(
          "Constraints that contradict the finished map by more than %2 m (--fail-over): %1, up to %3 m.")
          .arg(counted(over))
          .arg(*args.fail_over_m)
          .arg(largest_m, 0, 'f', 3));
  return kIncomplete;
}

}  // namespace

void addSlamGraph(Commands& commands, CLI::App& slam) {
  const auto info = std::make_shared<SlamArguments>();
  CLI::App* const info_command = addReading(
      commands, slam, "info", Text::tr("What a state file holds: trajectories, submaps, constraints"),
      Text::tr("State file (.pbstream)"), info, slamInfo);
  addJson(*info_command, info->json);
  const auto closures = std::make_shared<ClosuresArguments>();
  CLI::App* const closures_command =
      addReading(commands, slam, "closures",
                 Text::tr("Loop closures, those first that contradict the finished map most"),
                 Text::tr("State file (.pbstream) or robot address (or MAPWRIGHT_ROBOT)"), closures,
                 slamClosures, [](ClosuresArguments& args, const Invocation& before) {
                   if (!args.bag.empty()) onRecording(args.robot, args.bag, before.robot);
                 });
  closures_command->add_option(
      "--bag", closures->bag,
      help(Text::tr("Read recorded constraints: the name of a bag, or a file, with --at; "
                    "FILE?ns=/NAMESPACE is one robot of several")));
  addTime(*closures_command, "--at", closures->at);
  closures_command
      ->add_option("--kind", closures->kind, help(Text::tr("inter (loop closures), intra or all")))
      ->check(CLI::IsMember({"inter", "intra", "all"}));
  closures_command->add_option("--min", closures->min_m,
                               help(Text::tr("Only those of at least so many metres")));
  closures_command->add_option("--top", closures->top,
                               help(Text::tr("Only so many; 0: all (default: 20, with --json all)")));
  closures_command->add_option("--fail-over", closures->fail_over_m,
                               help(Text::tr("Exit code 1 if one is larger than so many metres")));
  addJson(*closures_command, closures->json);
}

}  // namespace mapwright::app
