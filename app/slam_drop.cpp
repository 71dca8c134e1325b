// `mapwright slam drop`: a state file with something left out (docs/command-line.md, "mapwright slam").
#include <charconv>

#include <CLI/CLI.hpp>
#include <QJsonArray>
#include <QJsonObject>

#include "app/command_text.h"
#include "app/output.h"
#include "app/robot_command.h"
#include "app/robot_factory.h"
#include "jobs/leave_out.h"
#include "pbstream/drop.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

struct DropArguments : RobotArguments {
  std::vector<int> trajectories;
  std::vector<std::string> submaps, closures;  // "0-4", "0-4:0-512"
  std::string output;
};

/// "0-4", "-1-4"; nullopt: it is no such id.
std::optional<std::pair<std::int32_t, std::int32_t>> idsFrom(std::string_view typed) {
  std::int32_t numbers[2] = {0, 0};
  const char* at = typed.data();
  const char* const end = at + typed.size();
  for (int i = 0; i < 2; ++i) {
    if (i == 1 && (at == end || *at++ != '-')) return std::nullopt;
    const auto [behind, error] = std::from_chars(at, end, numbers[i]);
    if (error != std::errc()) return std::nullopt;
    at = behind;
  }
  return at == end ? std::optional(std::pair(numbers[0], numbers[1])) : std::nullopt;
}

CommandResult<pbstream::Dropped> droppedBy(const DropArguments& args) {
  pbstream::Dropped what;
  what.trajectories.insert(args.trajectories.begin(), args.trajectories.end());
  for (const std::string& typed : args.submaps) {
    const auto ids = idsFrom(typed);
    if (!ids)
      return wrong(Text::tr("--submap %1: give trajectory and index, for example 0-4.")
                       .arg(oneLine(words::text(typed))));
    what.submaps.insert({ids->first, ids->second});
  }
  for (const std::string& typed : args.closures) {
    const std::size_t colon = typed.find(':');
    const auto submap = idsFrom(std::string_view(typed).substr(0, colon));
    const auto node =
        colon == std::string::npos ? std::nullopt : idsFrom(std::string_view(typed).substr(colon + 1));
    if (!submap || !node)
      return wrong(Text::tr("--closure %1: give submap and node, for example 0-4:0-512.")
                       .arg(oneLine(words::text(typed))));
    what.closures.emplace(map::SubmapId{submap->first, submap->second},
                          map::NodeId{node->first, node->second});
  }
  if (what.empty()) return wrong(Text::tr("Leave out what? Pass --trajectory, --submap or --closure."));
  return what;
}

CommandResult<int> slamDrop(RobotCommand& command, const DropArguments& args) {
  const auto what = droppedBy(args);
  if (!what) return passOn(what);
  const auto from = stateFileOf(words::text(args.robot));
  if (!from)
    return wrong(Text::tr("%1: this needs a Cartographer state file (.pbstream).")
                     .arg(oneLine(words::text(args.robot), 200)));
  const QString to = words::text(args.output);
  if (isStream(to))
    return wrong(Text::tr("%1: the new file is read back, so it cannot be written there.").arg(oneLine(to)));
  if (const auto why = notTogetherReason({to, words::text(args.report)})) return sharedOutput(*why);
  command.reportConnected();
  const auto receipt = jobs::leaveOut(*from, *what, to, [&] { return command.time().over(); });
  if (!receipt) return wrong(receipt.error());
  const QStringList damage = jobs::damageSentences(*receipt);
  for (const QString& sentence : damage) say(sentence);
  const int code = damage.isEmpty() ? kDone : kIncomplete;
  if (args.json) {
    printJson(QJsonObject{{QStringLiteral("written"), to},
                          {QStringLiteral("dropped"),
                           QJsonObject{{QStringLiteral("trajectories"), qint64(receipt->trajectories)},
                                       {QStringLiteral("submaps"), qint64(receipt->submaps)},
                                       {QStringLiteral("nodes"), qint64(receipt->nodes)},
                                       {QStringLiteral("inter"), qint64(receipt->inter)},
                                       {QStringLiteral("intra"), qint64(receipt->intra)},
                                       {QStringLiteral("records"), qint64(receipt->records)}}},
                          {QStringLiteral("records_rewritten"), qint64(receipt->rewritten)},
                          {QStringLiteral("warnings"), QJsonArray::fromStringList(damage)}});
    return code;
  }
  for (const QString& said : jobs::leftOutSentences(*receipt, to)) printLine(said);
  return code;
}

}  // namespace

void addSlamDrop(Commands& commands, CLI::App& slam) {
  const auto args = std::make_shared<DropArguments>();
  CLI::App* const command =
      addReading(commands, slam, "drop", Text::tr("Write a new state file with something left out"),
                 Text::tr("State file (.pbstream)"), args, slamDrop);
  command
      ->add_option("--trajectory", args->trajectories,
                   help(Text::tr("A trajectory, with all that belongs to it")))
      ->allow_extra_args(false);
  command->add_option("--submap", args->submaps, help(Text::tr("T-I: a submap, with its constraints")))
      ->allow_extra_args(false);
  command
      ->add_option("--closure", args->closures,
                   help(Text::tr("T-I:T-N: the loop closure of a submap and a node")))
      ->allow_extra_args(false);
  command->add_option("-o,--output", args->output, help(Text::tr("The new file; nothing may be there")))
      ->required();
  addJson(*command, args->json);
}

}  // namespace mapwright::app
