// `mapwright probe`: which robots answer at a host (docs/command-line.md, "mapwright probe").
#include <cmath>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <QCoreApplication>
#include <QEventLoop>
#include <QJsonArray>
#include <QJsonObject>
#include <QSet>

#include "app/command_text.h"
#include "app/commands.h"
#include "app/language.h"
#include "app/output.h"
#include "app/robot_factory.h"
#include "jobs/robot_search.h"
#include "sentences/fault_sentence.h"
#include "sentences/found_sentence.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

/// As typed.
struct ProbeArguments {
  std::string host;
  double timeout_s = 6;
  bool json = false, details = false;
};

QJsonValue orNull(const std::optional<std::int64_t>& count) {
  return count ? QJsonValue(qint64(*count)) : QJsonValue();
}

QJsonObject jsonOfFound(const robot::FoundRobot& robot, const robot::Addresses& addresses) {
  return {{QStringLiteral("kind"), words::text(addresses.kindOf(robot.address))},
          {QStringLiteral("address"), robot.address},
          {QStringLiteral("name"), robot.identity.name},
          {QStringLiteral("model"), robot.identity.model},
          {QStringLiteral("serial"), robot.identity.serial},
          {QStringLiteral("version"), robot.identity.version},
          {QStringLiteral("wants_secret"), robot.wants_secret},
          {QStringLiteral("topics"), orNull(robot.topics)},
          {QStringLiteral("services"), orNull(robot.services)}};
}

void printFound(const jobs::RobotSearch& search, const QString& host, const robot::Addresses& addresses,
                bool json) {
  const std::vector<robot::FoundRobot> found = search.found();
  if (json) {
    QJsonArray robots, others;
    for (const robot::FoundRobot& robot : found) robots << jsonOfFound(robot, addresses);
    for (const auto& row : search.rows()) {
      if (row.answer->found.empty())
        others << QJsonObject{{QStringLiteral("looked_for"), row.title},
                              {QStringLiteral("server"), row.server.toString()},
                              {QStringLiteral("reason"), sentences::wordsOf(row.answer->reason)}};
    }
    return printJson(QJsonObject{{QStringLiteral("host"), host},
                                 {QStringLiteral("found"), robots},
                                 {QStringLiteral("not_found"), others}});
  }
  if (found.empty()) return;
  std::vector<QStringList> table{{Text::tr("KIND"), Text::tr("ADDRESS"), Text::tr("IT SAYS")}};
  for (const robot::FoundRobot& robot : found)
    table.push_back({addresses.titleOf(robot.address), words::plainName(robot.address),
                     words::plainName(sentences::foundCalled(robot))});
  printTable(table);
}

/// The one reason that all have, or nothing.
QString commonReason(const jobs::RobotSearch& search) {
  QSet<QString> reasons;
  for (const auto& row : search.rows()) reasons << sentences::wordsOf(row.answer->reason);
  return reasons.size() == 1 ? *reasons.begin() : QString();
}

CommandResult<int> probe(const ProbeArguments& args) {
  if (const auto why = noTimeoutReason(args.timeout_s)) return wrong(*why);
  const robot::Addresses addresses = knownAddresses();
  const QString typed = words::text(args.host);
  const auto host = addresses.bareHost(typed);
  if (const auto why = host ? std::nullopt : robot::noPortReason(typed)) return wrong(words::plainName(*why));
  if (!host)
    return wrong(
        Text::tr("%1 is not a host. Give its name or address, with or without a port, for example "
                 "192.168.25.25 or dock-3.local:8090.")
            .arg(words::plainName(typed.mid(typed.lastIndexOf(QLatin1Char('@')) + 1))));  // no password
  jobs::RobotSearch search(probesOf(*host), std::chrono::milliseconds(std::llround(args.timeout_s * 1000)));
  QEventLoop loop;
  QObject::connect(&search, &jobs::RobotSearch::ended, &loop, &QEventLoop::quit);
  if (!search.over()) loop.exec();
  printFound(search, typed.trimmed(), addresses, args.json);
  if (args.details) {
    for (const auto& row : search.rows()) {
      if (row.answer->found.empty())
        say(Text::tr("%1, %2: %3")
                .arg(row.title, row.server.toString(), sentences::wordsOf(row.answer->reason)));
    }
  }
  if (!search.found().empty()) return kDone;
  const QString common = commonReason(search);
  return tl::make_unexpected(CommandFailure{
      kUnreachable, common.isEmpty()
                        ? Text::tr("%1: no robot answers there. --details says why, port by port.")
                              .arg(words::plainName(typed))
                        : Text::tr("%1: no robot answers there: %2.").arg(words::plainName(typed), common)});
}

}  // namespace

void addProbe(Commands& commands) {
  const auto args = std::make_shared<ProbeArguments>();
  CLI::App* const command = commands.program().add_subcommand(
      "probe", help(Text::tr("Find the robots at a host and their addresses")));
  command
      ->add_option(
          "host", args->host,
          help(Text::tr("Name or address, for example dock-3.local; with a port, only that port is asked")))
      ->required();
  addTimeout(*command, args->timeout_s, Text::tr("Timeout in seconds"));
  command->add_flag("--details", args->details, help(Text::tr("Say for each port why there is no robot")));
  addJson(*command, args->json);
  commands.add(command, [args](const Invocation& before) {
    const InPlaceOfSpeaker own;
    const QCoreApplication application(before.argc, before.argv);
    const CommandResult<int> done = probe(*args);
    return done ? *done : refuse(done.error().exit_code, done.error().sentence);
  });
}

}  // namespace mapwright::app
