// `mapwright projections …`: what a robot projects from its 3D map. Source:
// docs/protocols/rep130-map-dispatcher.md, "Projections".
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonObject>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/maps_command.h"
#include "app/option_words.h"
#include "app/output_paths.h"
#include "app/robot_access.h"
#include "app/table.h"
#include "map/map_part.h"
#include "robot/map_dispatch.h"
#include "robot/ros/faults.h"
#include "sentences/failure_sentence.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

class ProjectionsText {
  Q_DECLARE_TR_FUNCTIONS(Projections)
};

/// The words as typed; empty = not given.
struct ProjectionsWords {
  std::string robot;
  AccessWords access;
  std::vector<std::string> wanted;  // X,Y,WIDTH,HEIGHT,MIN_Z,MAX_Z or the same with ,FRAME
  std::string report;
  double timeout_s = 60;
  bool json = false;
  bool none = false;  // project nothing
};

using Projections = std::vector<map::Projection>;

using words::text;

tl::expected<map::Projection, QString> projectionFrom(const std::string& typed) {
  const QStringList parts = text(typed).split(QLatin1Char(','));
  const auto given = numbersFrom(parts.mid(0, 6).join(QLatin1Char(',')).toStdString());
  const bool whole = given && (parts.size() == 6 || parts.size() == 7);
  map::Projection one;
  if (whole) one = {{}, {(*given)[0], (*given)[1]}, {(*given)[2], (*given)[3]}, (*given)[4], (*given)[5]};
  if (!whole || map::flawOf(one) != map::ProjectionFlaw::None) {
    return tl::make_unexpected(
        ProjectionsText::tr("--projection %1: give X,Y,WIDTH,HEIGHT,MIN_Z,MAX_Z in metres, from the lower "
                            "left corner, followed by the frame if it is not that of the map.")
            .arg(text(typed)));
  }
  if (parts.size() == 7) one.frame = parts.back().trimmed().toStdString();
  return one;
}

QJsonObject jsonOf(const map::Projection& one) {
  return {{QStringLiteral("frame"), text(one.frame)}, {QStringLiteral("x"), one.corner_m.x()},
          {QStringLiteral("y"), one.corner_m.y()},    {QStringLiteral("width"), one.size_m.x()},
          {QStringLiteral("height"), one.size_m.y()}, {QStringLiteral("min_z"), one.min_z_m},
          {QStringLiteral("max_z"), one.max_z_m}};
}

void print(const Projections& all, bool json) {
  if (json) {
    QJsonArray rows;
    for (const map::Projection& one : all) rows << jsonOf(one);
    printJson(rows);
    return;
  }
  if (all.empty()) {
    std::printf("%s\n", qUtf8Printable(ProjectionsText::tr("There are no projections.")));
    return;
  }
  const auto metres = [](double value) { return QString::number(value, 'f', 2); };
  std::vector<QStringList> table{{ProjectionsText::tr("NUMBER"), ProjectionsText::tr("X (m)"),
                                  ProjectionsText::tr("Y (m)"), ProjectionsText::tr("WIDTH (m)"),
                                  ProjectionsText::tr("HEIGHT (m)"), ProjectionsText::tr("MIN Z (m)"),
                                  ProjectionsText::tr("MAX Z (m)"), ProjectionsText::tr("FRAME")}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const map::Projection& one = all[i];
    table.push_back({QString::number(i), metres(one.corner_m.x()), metres(one.corner_m.y()),
                     metres(one.size_m.x()), metres(one.size_m.y()), metres(one.min_z_m), metres(one.max_z_m),
                     words::plainName(one.frame)});
  }
  printTable(table);
}

CommandResult<int> list(MapReading& reading, const ProjectionsWords& words) {
  robot::MapDispatch* const dispatch = reading.session().robot().mapDispatch();
  if (!dispatch) return tl::make_unexpected(reading.lacks(robot::Capability::Dispatch));
  const auto told = reading.ask<Projections>(
      [&](robot::OutcomeTo<Projections> reply) { return dispatch->projections(std::move(reply)); });
  if (!told && told.error().cause.code == robot::ros::fault::ProjectionsNotTold) {
    return tl::make_unexpected(reading.failure(kIncomplete, text(sentences::sentenceOf(told.error()))));
  }
  if (!told) return tl::make_unexpected(reading.failure(told.error()));
  const std::vector<std::string> silent = dispatch->silent();
  if (!told->empty() || silent.empty() || words.json) print(*told, words.json);
  for (const std::string& topic : silent)
    reading.note(ProjectionsText::tr("%1: it had no effect.").arg(words::plainName(topic)));
  return silent.empty() ? kDone : kIncomplete;
}

CommandResult<int> set(MapReading& reading, const ProjectionsWords& words, const Projections& wanted) {
  robot::MapDispatch* const dispatch = reading.session().robot().mapDispatch();
  if (!dispatch) return tl::make_unexpected(reading.lacks(robot::Capability::Dispatch));
  if (dispatch->offered(robot::DispatchService::ReadProjections) &&
      !dispatch->offered(robot::DispatchService::ChangeProjections)) {
    return tl::make_unexpected(reading.failure(
        kRobotError,
        ProjectionsText::tr("Its set_map_projections has the type that REP 130 defines, which has no fields: "
                            "projections can only be read (mapwright projections list).")));
  }
  const auto told = reading.ask<Projections>(
      [&](robot::OutcomeTo<Projections> reply) { return dispatch->project(wanted, std::move(reply)); });
  if (!told) return tl::make_unexpected(reading.failure(told.error()));
  print(*told, words.json);
  if (map::differing(wanted, *told) == 0) return kDone;
  return tl::make_unexpected(reading.failure(
      kIncomplete, ProjectionsText::tr("The robot accepted it, but does not project what was requested.")));
}

int runProjections(bool sets, const ProjectionsWords& words, int& argc, char** argv) {
  const auto work = [&](MapsCommand& command) -> CommandResult<int> {
    const auto wrong = [](const QString& sentence) {
      return tl::make_unexpected(CommandFailure{kUsage, sentence});
    };
    Projections wanted;
    for (const std::string& typed : words.wanted) {
      const auto one = projectionFrom(typed);
      if (!one) return wrong(one.error());
      wanted.push_back(*one);
    }
    if (sets && wanted.empty() != words.none) {
      return wrong(ProjectionsText::tr("projections set: pass --projection, once for each one, or --none."));
    }
    const auto access = RobotAccess::read(words.access, text(words.robot));
    if (!access) return wrong(access.error());
    const QString address = text(words.robot);
    auto reading = command.open(address, access->forAddress(address), MapReading::Purpose::Maps);
    if (!reading) return tl::make_unexpected(reading.error());
    return sets ? set(**reading, words, wanted) : list(**reading, words);
  };
  return MapsCommand(words.timeout_s, text(words.report)).run(argc, argv, work);
}

}  // namespace

void addProjections(Commands& commands) {
  const auto shared = std::make_shared<ProjectionsWords>();
  ProjectionsWords& words = *shared;
  CLI::App* projections = commands.program().add_subcommand(
      "projections",
      help(ProjectionsText::tr(
          "What a map dispatcher (REP 130) projects from its 3D map onto a plane: list, set")));
  projections->require_subcommand(1);
  const auto add = [&](const char* name, const std::string& what, bool sets) {
    CLI::App* command = projections->add_subcommand(name, what);
    addRobot(*command, words.robot, words.access, ProjectionsText::tr("Robot address (or MAPWRIGHT_ROBOT)"));
    addTimeout(*command, words.timeout_s);
    addReport(*command, words.report);
    addJson(*command, words.json);
    commands.add(command, shared, [sets](const ProjectionsWords& typed, int& argc, char** argv) {
      return runProjections(sets, typed, argc, argv);
    });
    return command;
  };
  add("list", help(ProjectionsText::tr("List the current projections")), false);
  CLI::App* command = add(
      "set", help(ProjectionsText::tr("Replace all projections, then print what the robot projects")), true);
  command
      ->add_option(
          "--projection", words.wanted,
          help(ProjectionsText::tr("X,Y,WIDTH,HEIGHT,MIN_Z,MAX_Z in metres, from the lower left corner, and "
                                   ",FRAME if it is not that of the map; may be repeated")))
      ->allow_extra_args(false);
  command->add_flag("--none", words.none, help(ProjectionsText::tr("Project nothing")));
}

}  // namespace mapwright::app
