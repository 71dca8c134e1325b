// `mapwright projections …`: what a robot projects from its 3D map. Source:
// docs/protocols/rep130-map-dispatcher.md, "Projections".
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <QJsonArray>
#include <QJsonObject>

#include "app/command_text.h"
#include "app/output.h"
#include "app/robot_command.h"
#include "map/map_part.h"
#include "robot/faults.h"
#include "robot/map_dispatch.h"
#include "sentences/failure_sentence.h"
#include "words/fixed.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

/// The options as typed; empty = not given.
struct ProjectionsArguments : RobotArguments {
  std::vector<std::string> wanted;  // X,Y,WIDTH,HEIGHT,MIN_Z,MAX_Z or the same with ,FRAME
  bool none = false;                // project nothing
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
        Text::tr("--projection %1: give X,Y,WIDTH,HEIGHT,MIN_Z,MAX_Z in metres, from the lower "
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
    printLine(Text::tr("There are no projections."));
    return;
  }
  const auto metres = [](double value) { return words::fixed(value, 2); };
  std::vector<QStringList> table{{Text::tr("NUMBER"), Text::tr("X (m)"), Text::tr("Y (m)"),
                                  Text::tr("WIDTH (m)"), Text::tr("HEIGHT (m)"), Text::tr("MIN Z (m)"),
                                  Text::tr("MAX Z (m)"), Text::tr("FRAME")}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const map::Projection& one = all[i];
    table.push_back({QString::number(i), metres(one.corner_m.x()), metres(one.corner_m.y()),
                     metres(one.size_m.x()), metres(one.size_m.y()), metres(one.min_z_m), metres(one.max_z_m),
                     words::plainName(one.frame)});
  }
  printTable(table);
}

CommandResult<int> list(RobotReading& reading, robot::MapDispatch& dispatch,
                        const ProjectionsArguments& args) {
  const auto told = reading.ask<Projections>(
      [&](robot::OutcomeTo<Projections> reply) { return dispatch.projections(std::move(reply)); });
  if (!told && told.error().cause.code == robot::fault::ProjectionsNotTold) {
    return reading.failure(kIncomplete, text(sentences::sentenceOf(told.error())));
  }
  if (!told) return reading.failure(told.error());
  const std::vector<std::string> silent = dispatch.silent();
  if (!told->empty() || silent.empty() || args.json) print(*told, args.json);
  for (const std::string& topic : silent)
    reading.addRemark(Text::tr("%1: it had no effect.").arg(words::plainName(topic)));
  return silent.empty() ? kDone : kIncomplete;
}

CommandResult<int> set(RobotReading& reading, robot::MapDispatch& dispatch, const ProjectionsArguments& args,
                       const Projections& wanted) {
  if (dispatch.offered(robot::DispatchService::ReadProjections) &&
      !dispatch.offered(robot::DispatchService::ChangeProjections)) {
    return reading.failure(
        kRobotError,
        Text::tr("Its set_map_projections has the type that REP 130 defines, which has no fields: "
                 "projections can only be read (mapwright projections list)."));
  }
  const auto told = reading.ask<Projections>(
      [&](robot::OutcomeTo<Projections> reply) { return dispatch.project(wanted, std::move(reply)); });
  if (!told) return reading.failure(told.error());
  print(*told, args.json);
  if (map::differing(wanted, *told) == 0) return kDone;
  return reading.failure(kIncomplete,
                         Text::tr("The robot accepted it, but does not project what was requested."));
}

CommandResult<int> runProjections(bool sets, RobotCommand& command, const ProjectionsArguments& args) {
  Projections wanted;
  for (const std::string& typed : args.wanted) {
    const auto one = projectionFrom(typed);
    if (!one) return wrong(one.error());
    wanted.push_back(*one);
  }
  if (sets && wanted.empty() != args.none)
    return wrong(Text::tr("projections set: pass --projection, once for each one, or --none."));
  const auto reading = command.open();
  if (!reading) return passOn(reading);
  robot::MapDispatch* const dispatch = (*reading)->session().robot().mapDispatch();
  if (!dispatch) return (*reading)->lacks(robot::Capability::Dispatch);
  return sets ? set(**reading, *dispatch, args, wanted) : list(**reading, *dispatch, args);
}

}  // namespace

void addProjections(Commands& commands) {
  const auto shared = std::make_shared<ProjectionsArguments>();
  ProjectionsArguments& args = *shared;
  CLI::App* projections = commands.program().add_subcommand(
      "projections",
      help(Text::tr("Projections of a map dispatcher's 3D map onto a plane (REP 130): list, set")));
  projections->require_subcommand(1);
  const auto add = [&](const char* name, const QString& what, bool sets) {
    CLI::App* command =
        addReading(commands, *projections, name, what, Text::tr("Robot address (or MAPWRIGHT_ROBOT)"), shared,
                   [sets](RobotCommand& each, const ProjectionsArguments& typed) {
                     return runProjections(sets, each, typed);
                   });
    addJson(*command, args.json);
    return command;
  };
  add("list", Text::tr("List the current projections"), false);
  CLI::App* command =
      add("set", Text::tr("Replace all projections, then print what the robot projects"), true);
  command
      ->add_option("--projection", args.wanted,
                   help(Text::tr("X,Y,WIDTH,HEIGHT,MIN_Z,MAX_Z in metres, from the lower left corner, and "
                                 ",FRAME if it is not that of the map; may be repeated")))
      ->allow_extra_args(false);
  command->add_flag("--none", args.none, help(Text::tr("Project nothing")));
}

}  // namespace mapwright::app
