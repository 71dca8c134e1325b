// `mapwright maps set-pose|locate`: where the robot believes to be (docs/command-line.md).
#include <CLI/CLI.hpp>
#include <QJsonObject>

#include "app/command_text.h"
#include "app/output.h"
#include "app/robot_command.h"
#include "jobs/set_pose.h"
#include "robot/localization.h"
#include "sentences/absence_sentence.h"
#include "words/fixed.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

using words::text;

struct PoseArguments : RobotArguments {
  std::string at;  // X,Y,YAW
  bool adjust = false;
};

QJsonObject poseJson(const geometry::Pose2& pose) {
  return {{QStringLiteral("x"), pose.x_m},
          {QStringLiteral("y"), pose.y_m},
          {QStringLiteral("yaw_rad"), pose.yaw_rad}};
}

CommandResult<int> mapsSetPose(RobotCommand& command, const PoseArguments& args) {
  const auto numbers = numbersFrom(args.at);
  if (!numbers || numbers->size() != 3) {
    return wrong(Text::tr("--at %1: give X,Y,YAW: metres, and the heading in degrees, for example 1.5,-2,90.")
                     .arg(text(args.at)));
  }
  const robot::PoseOrder order{
      {(*numbers)[0], (*numbers)[1], geometry::normalizeAngle(geometry::radiansFromDegrees((*numbers)[2]))},
      args.adjust};
  if (const QString why = jobs::noPoseReason(order.pose); !why.isEmpty()) return wrong(why);
  const auto opened = command.open();
  if (!opened) return passOn(opened);
  RobotReading& reading = **opened;
  robot::Localization* const localization = reading.session().robot().localization();
  if (!localization) return reading.lacks(robot::Capability::Localization);
  const auto now = reading.ask<geometry::Pose2>([&](robot::OutcomeTo<geometry::Pose2> reply) {
    return localization->setPose(order, std::move(reply));
  });
  if (!now) {
    map::Failure failure = now.error();
    failure.asked_for = map::AskedFor::Change;
    return reading.failure(failure);
  }
  const jobs::PoseDeviation off = jobs::deviation(order, *now);
  if (args.json) {
    printJson(QJsonObject{{QStringLiteral("set"), poseJson(order.pose)},
                          {QStringLiteral("now"), poseJson(*now)},
                          {QStringLiteral("distance"), off.metres},
                          {QStringLiteral("turned_rad"), off.radians},
                          {QStringLiteral("as_set"), off.as_asked}});
  }
  const QString said = jobs::poseReport(order, *now);
  if (!off.as_asked) return reading.failure(kIncomplete, said);
  if (!args.json) printLine(said);
  return kDone;
}

CommandResult<int> mapsLocate(RobotCommand& command, const PoseArguments& args) {
  const auto opened = command.open();
  if (!opened) return passOn(opened);
  RobotReading& reading = **opened;
  robot::Localization* const localization = reading.session().robot().localization();
  if (!localization) return reading.lacks(robot::Capability::Localization);
  ProgressLine line;
  line.tell(Text::tr("The robot is searching its map for its position…"));
  const auto found = reading.ask<map::GlobalPositioning>([&](robot::OutcomeTo<map::GlobalPositioning> reply) {
    return localization->findItself(std::move(reply));
  });
  line.clear();
  if (!found) {
    map::Failure failure = found.error();
    failure.asked_for = map::AskedFor::Action;
    return reading.failure(failure);
  }
  const bool itself = jobs::foundItself(*found);
  if (args.json) {
    printJson(QJsonObject{
        {QStringLiteral("found"), itself},
        {QStringLiteral("needs_confirmation"), found->needs_confirmation.value_or(false)},
        {QStringLiteral("score"), found->score ? QJsonValue(*found->score) : QJsonValue()},
        {QStringLiteral("pose"), found->pose ? QJsonValue(poseJson(*found->pose)) : QJsonValue()}});
  }
  QString said = jobs::searchReport(*found);
  if (!itself && found->pose && found->needs_confirmation.value_or(false)) {
    said += QLatin1Char(' ') + Text::tr("mapwright maps set-pose --at %1,%2,%3 does.")
                                   .arg(words::fixed(found->pose->x_m, 3), words::fixed(found->pose->y_m, 3),
                                        words::fixed(geometry::degreesFromRadians(found->pose->yaw_rad), 2));
  }
  if (!itself) return reading.failure(kIncomplete, said);
  if (!args.json) printLine(said);
  return kDone;
}

}  // namespace

void addPoses(Commands& commands, CLI::App& maps) {
  const auto args = std::make_shared<PoseArguments>();
  const auto add = [&](const char* name, const QString& about, auto run) {
    CLI::App* const command =
        addReading(commands, maps, name, about, Text::tr("Robot address (or MAPWRIGHT_ROBOT)"), args, run);
    addJson(*command, args->json);
    return command;
  };
  CLI::App* const set =
      add("set-pose", Text::tr("Tell the robot where it is on its current map"), mapsSetPose);
  set->add_option("--at", args->at, help(Text::tr("X,Y,YAW in metres and degrees")))->required();
  set->add_flag("--adjust", args->adjust, help(Text::tr("Let the robot correct the pose with its sensors")));
  add("locate", Text::tr("Let the robot find itself on its current map"), mapsLocate);
}

}  // namespace mapwright::app
