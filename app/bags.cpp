// `mapwright bags …`: what a robot has recorded, and recordings on this computer (docs/command-line.md).
#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <CLI/CLI.hpp>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonObject>

#include "app/bag_json.h"
#include "app/bag_reading.h"
#include "app/command_text.h"
#include "app/map_request.h"
#include "app/output.h"
#include "app/robot_factory.h"
#include "app/snapshot.h"
#include "excerpt/excerpt.h"
#include "incident/report.h"
#include "robot/faults.h"
#include "robot/sends_map.h"
#include "ui/kit/status_text.h"
#include "words/file_name.h"
#include "words/listed.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

using words::text;

QStringList rowOf(const robot::BagEntry& entry) {
  const QString size =
      entry.size_bytes ? ui::bytesText(*entry.size_bytes) : words::plainName(entry.size_text);
  const QString end =
      entry.end_s ? incident::utcText(*entry.end_s).chopped(4) : words::plainName(entry.end_text);
  return {entry.key.kind == robot::BagKind::Recording ? Text::tr("recording") : Text::tr("bag"),
          size.isEmpty() ? QStringLiteral("-") : size, end.isEmpty() ? QStringLiteral("-") : end,
          words::plainName(entry.key.name)};
}

/// The default file name of a download. The bag's name comes from the robot, and must not lead to another
/// folder.
QString fileFor(const BagsArguments& args) {
  if (!args.output.empty()) return text(args.output);
  return words::fileName(QFileInfo(text(args.name)).fileName(), {});
}

CommandResult<int> bagsList(RobotCommand& command, const BagsArguments& args) {
  auto opened = BagReading::open(command);
  if (!opened) return passOn(opened);
  BagReading& bags = *opened;
  const auto rows = bags.robot().ask<std::vector<robot::BagEntry>>(
      [&](robot::OutcomeTo<std::vector<robot::BagEntry>> reply) {
        return bags.library().list(std::move(reply));
      });
  if (!rows) return bags.failure(rows.error());
  bags.robot().insistOnAll();  // one of the two lists is incomplete
  if (args.json) {
    QJsonArray all;
    for (const robot::BagEntry& entry : *rows) all.append(bagJson(entry));
    printJson(all);
    return kDone;
  }
  if (rows->empty()) {
    printLine(Text::tr("There are no bags."));
    return kDone;
  }
  std::vector<QStringList> table{
      {Text::tr("KIND"), Text::tr("SIZE"), Text::tr("END (UTC)"), Text::tr("NAME")}};
  for (const robot::BagEntry& entry : *rows) table.push_back(rowOf(entry));
  printTable(table);
  return kDone;
}

CommandResult<int> bagsInfo(RobotCommand& command, const BagsArguments& args) {
  auto opened = BagReading::open(command);
  if (!opened) return passOn(opened);
  BagReading& bags = *opened;
  const robot::BagKey key = bags.keyOf(args.name);
  const auto info = bags.robot().ask<robot::BagInfo>(
      [&](robot::OutcomeTo<robot::BagInfo> reply) { return bags.library().info(key, std::move(reply)); });
  if (!info) return bags.failure(info.error());
  if (args.json) {
    printJson(infoJson(args.name, *info));
    return kDone;
  }
  printTable(infoRows(args.name, *info));
  if (const auto topics = topicRows(*info); !topics.empty()) {
    printOut("\n");
    printTable(topics);
  }
  return kDone;
}

CommandResult<int> bagsDownload(RobotCommand& command, const BagsArguments& args) {
  auto opened = BagReading::open(command);
  if (!opened) return passOn(opened);
  BagReading& bags = *opened;
  const QString path = fileFor(args);
  if (path.isEmpty()) return wrong(Text::tr("Where should it be saved? Pass -o FILE."));
  if (isStream(path))
    return wrong(Text::tr("A download can be resumed, so it must go to a regular file (-o FILE)."));
  if (const auto why = notCreatedReason(path, args.force)) return wrong(*why);
  const robot::BagKey key = bags.keyOf(args.name);
  const auto line = std::make_shared<ProgressLine>();  // the robot may report progress after the end
  const auto done = bags.robot().ask<robot::BagDownload>([&](robot::OutcomeTo<robot::BagDownload> reply) {
    robot::Call call = bags.library().download(key, path, std::move(reply));
    call.onProgress([line](robot::Progress progress) {
      const QString bytes = ui::bytesText(progress.bytes);
      const QString of = progress.of_bytes ? ui::bytesText(*progress.of_bytes) : QStringLiteral("?");
      line->tell(Text::tr("%1 of %2").arg(bytes, of));
    });
    return call;
  });
  line->clear();
  if (!done) {
    const auto failure = bags.failure(done.error());
    if (done.error().cause.code == robot::fault::BagFileNotWritten) return wrong(failure.value().sentence);
    return failure;
  }
  if (args.json) {
    printJson(QJsonObject{{QStringLiteral("name"), text(args.name)},
                          {QStringLiteral("file"), done->path},
                          {QStringLiteral("bytes"), qint64(done->bytes)},
                          {QStringLiteral("resumed"), done->resumed}});
  } else {
    printLine(words::about(oneLine(done->path), ui::bytesText(done->bytes)));
  }
  return kDone;
}

CommandResult<int> bagsDelete(RobotCommand& command, const BagsArguments& args) {
  auto opened = BagReading::open(command);
  if (!opened) return passOn(opened);
  BagReading& bags = *opened;
  if (!args.yes)
    return wrong(Text::tr("Deleting a bag cannot be undone. Pass --yes to delete %1.")
                     .arg(words::plainName(args.name)));
  const robot::BagKey key = bags.keyOf(args.name);
  const auto done = bags.robot().ask<robot::BagKey>(
      [&](robot::OutcomeTo<robot::BagKey> reply) { return bags.library().remove(key, std::move(reply)); });
  if (!done) return bags.failure(done.error());
  if (args.json) printJson(QJsonObject{{QStringLiteral("name"), text(args.name)}});
  return kDone;
}

CommandResult<int> bagsRecord(RobotCommand& command, const BagsArguments& args) {
  auto opened = BagReading::open(command);
  if (!opened) return passOn(opened);
  BagReading& bags = *opened;
  const robot::BagOrder order{args.suffix, args.duration, args.category};
  const auto entry = bags.robot().ask<robot::BagEntry>([&](robot::OutcomeTo<robot::BagEntry> reply) {
    return bags.library().record(order, std::move(reply));
  });
  if (!entry) return bags.failure(entry.error());
  if (args.json) {
    printJson(bagJson(*entry));
  } else if (!entry->key.name.empty()) {
    printLine(words::plainName(entry->key.name));
  }
  return kDone;
}

/// The messages of a range between two times. False: the output accepts no more.
bool printFrames(const replay::Chunk& chunk, const excerpt::TimeSpan& span,
                 const std::vector<std::string>& topics, std::set<std::string>& found) {
  for (std::size_t i = 0; i < chunk.order.size(); ++i) {
    const robot::BagMessage& message = chunk.at(i);
    if (!span.holds(message.message.received_s)) continue;
    if (!excerpt::isOneOf(topics, message.message.topic)) continue;
    found.insert(message.message.topic);
    if (!printOut(excerpt::jsonLine(chunk.source->textOf(message)) + "\n")) return false;
  }
  return true;
}

/// What a picture would report: that the file has no map, and which one its messages name.
std::optional<QString> noMapIn(const BagReading& bags, const replay::Moment& moment) {
  robot::Robot& robot = bags.robot().session().robot();
  robot::MapCatalogue* const maps = robot.mapCatalogue();
  if (!robot.isLocal() || robot::sendsItsMap(robot) || !maps) return std::nullopt;
  const auto kept = bags.robot().ask<std::vector<map::CatalogueEntry>>(
      [&](robot::OutcomeTo<std::vector<map::CatalogueEntry>> reply) { return maps->list(std::move(reply)); });
  if (!kept || !kept->empty()) return std::nullopt;
  return noMapSentence(moment.at.world.live.map_info);
}

CommandResult<int> bagsFrames(RobotCommand& command, const BagsArguments& args) {
  auto opened = BagReading::open(command);
  if (!opened) return passOn(opened);
  const auto replayed = opened->readThrough(args.name, BagReading::Texts::Whole);
  if (!replayed) return passOn(replayed);
  const auto span = timeSpanFrom(args, *(*replayed)->info());
  if (!span) return passOn(span);
  bool taken = true;
  std::set<std::string> found;
  const auto read =
      opened->readRanges(span->from_s, span->to_s, [&](const replay::Chunk& chunk) -> CommandResult<void> {
        taken = printFrames(chunk, *span, args.topics, found);
        // Stops reading if nobody takes the output; the reason is reported at the end.
        if (!taken) return wrong({});
        return {};
      });
  if (!taken) return kUsage;
  if (!read) return passOn(read);
  opened->reportNotFound(args.topics, *span, found.size(), found);
  opened->reportUnreadable(span->to_s.value_or(HUGE_VAL), span->from_s);
  return kDone;
}

CommandResult<int> bagsState(RobotCommand& command, const BagsArguments& args) {
  auto opened = BagReading::open(command);
  if (!opened) return passOn(opened);
  const auto replayed = opened->replay(args.name);
  if (!replayed) return passOn(replayed);
  const robot::BagInfo bag = *(*replayed)->info();
  const auto at_s = timeFrom(args.at, QStringLiteral("--at"), bag);
  if (!at_s) return passOn(at_s);
  std::optional<double> from_s;
  if (!args.from.empty()) {
    const auto time = timeFrom(args.from, QStringLiteral("--from"), bag);
    if (!time) return passOn(time);
    from_s = *time;
  }
  // Plays from there: looks at each range on the way.
  while (from_s && *from_s < *at_s) {
    const auto moment = opened->momentAt(*from_s);
    if (!moment) return passOn(moment);
    const replay::Cell* cell = (*replayed)->chunks().cellAt(*from_s);
    if (!cell || replay::secondsOf(cell->until) <= *from_s) break;
    from_s = replay::secondsOf(cell->until);
  }
  const auto moment = opened->momentAt(*at_s);
  if (!moment) return passOn(moment);
  const std::optional<QString> no_map = noMapIn(*opened, *moment);
  if (args.json) {
    QJsonObject state = stateJson(*at_s, *moment, bag);
    if (no_map) state[QStringLiteral("no_map")] = *no_map;
    printJson(state);
  } else {
    std::vector<QStringList> rows = stateRows(*at_s, *moment, bag);
    if (no_map) rows.insert(rows.begin() + 1, {Text::tr("map"), *no_map});
    printTable(rows);
  }
  opened->reportUnreadable(*at_s);
  return kDone;
}

/// Parses --kind; empty = all of them.
CommandResult<std::set<replay::EventGroup>> groupsFrom(const std::string& kinds) {
  std::set<replay::EventGroup> groups;
  if (kinds.empty()) return std::set(std::begin(replay::kEventGroups), std::end(replay::kEventGroups));
  for (const QString& word : text(kinds).split(QLatin1Char(','))) {
    const auto* const found =
        std::find_if(std::begin(replay::kEventGroups), std::end(replay::kEventGroups),
                     [asked = word.trimmed().toLower().toStdString()](replay::EventGroup group) {
                       return replay::wordOf(group) == asked;
                     });
    if (found == std::end(replay::kEventGroups))
      return wrong(Text::tr("--kind: \"%1\" is unknown. Choose from: alerts, planner, position, maps, stops.")
                       .arg(word));
    groups.insert(*found);
  }
  return groups;
}

CommandResult<int> bagsEvents(RobotCommand& command, const BagsArguments& args) {
  const auto groups = groupsFrom(args.kinds);
  if (!groups) return passOn(groups);
  auto opened = BagReading::open(command);
  if (!opened) return passOn(opened);
  const auto replayed = opened->replay(args.name);
  if (!replayed) return passOn(replayed);
  replay::Reading& reading = **replayed;
  if (const auto read = opened->readWhole(); !read) return passOn(read);
  std::vector<replay::Event> events = replay::eventsOf(reading.index().digests());
  std::erase_if(events,
                [&](const replay::Event& event) { return !groups->contains(replay::groupOf(event.kind)); });
  opened->reportUnreadable(HUGE_VAL);
  if (args.json) {
    printJson(eventsJson(events));
    return kDone;
  }
  std::vector<QStringList> table;
  for (const replay::Event& event : events) table.push_back(eventRow(event));
  if (table.empty()) printLine(Text::tr("Nothing happened."));
  printTable(table);
  return kDone;
}

struct BagCommand {
  const char* name;
  QString about;
  CommandResult<int> (*run)(RobotCommand&, const BagsArguments&);
};

std::vector<BagCommand> bagCommands() {
  return {
      {"list", Text::tr("List the bags and recordings of a robot"), bagsList},
      {"info", Text::tr("Show the times and topics, with their counts and mean rates"), bagsInfo},
      {"frames", Text::tr("Print the messages as recorded, one per line"), bagsFrames},
      {"state", Text::tr("Show the state at a given time"), bagsState},
      {"events", Text::tr("List alerts, planner states, position jumps, map changes and lost localization"),
       bagsEvents},
      {"report", Text::tr("Write an HTML report of what the robot believed at a given time"), bagsReport},
      {"download", Text::tr("Download a bag, or resume an interrupted download"), bagsDownload},
      {"export", Text::tr("Export a part as MCAP or JSON lines"), bagsExport},
      {"track", Text::tr("Export the robot's path as CSV, GeoJSON or TUM"), bagsTrack},
      {"repair",
       Text::tr("Recover what is intact in an interrupted or damaged recording and write it as a "
                "complete MCAP file"),
       bagsRepair},
      {"split", Text::tr("Split a recording into parts of equal length that can each be replayed alone"),
       bagsSplit},
      {"merge", Text::tr("Merge several recordings into one"), bagsMerge},
      {"delete", Text::tr("Delete a bag from the robot (--yes)"), bagsDelete},
      {"record", Text::tr("Make the robot record a bag"), bagsRecord}};
}

void addBagOptions(const std::string& name, CLI::App& command, BagsArguments& args) {
  const auto is = [&](auto... names) { return ((name == names) || ...); };
  if (is("merge"))
    command.add_option("files", args.files, help(Text::tr("Recordings on this computer")))->required();
  if (!is("list", "record", "merge"))
    command
        .add_option("name", args.name,
                    help(Text::tr("Name of the bag (see mapwright bags list), or a file; FILE?ns=/NAMESPACE "
                                  "is one robot of several")))
        ->required();
  if (is("frames", "state", "export", "track", "merge")) addTime(command, "--from", args.from);
  if (is("frames", "export", "track", "merge")) addTime(command, "--to", args.to);
  if (is("frames", "export", "split", "merge"))
    command
        .add_option("--topic", args.topics,
                    help(Text::tr("Only messages of this topic; separate several with commas")))
        ->delimiter(',')
        ->allow_extra_args(false);
  if (is("export", "track")) {
    command.add_option("-o,--output", args.output, help(Text::tr("Output file; - is the standard output")))
        ->required();
    command.add_option("--format", args.format,
                       name == "export"
                           ? help(Text::tr("mcap or jsonl; by default taken from the file name"))
                           : help(Text::tr("csv, geojson or tum; by default taken from the file name")));
    addForce(command, args.force);
  }
  if (is("repair", "split", "merge")) {
    command
        .add_option("-o,--output", args.output,
                    is("split") ? help(Text::tr("Names of the MCAP files, with a number: part-%03d.mcap"))
                                : help(Text::tr("The MCAP file to write")))
        ->required();
    addForce(command, args.force);
  }
  if (is("split"))
    command.add_option("--every", args.every_s, help(Text::tr("Length of each part in seconds")))
        ->capture_default_str();
  if (is("events"))
    command.add_option(
        "--kind", args.kinds,
        help(Text::tr("Only these kinds, separated by commas: alerts, planner, position, maps, stops")));
  if (is("state", "report")) addTime(command, "--at", args.at, Needed::Yes);
  if (is("report")) {
    command.add_option(
        "--against", args.against,
        help(Text::tr(
            "Show another run beside it: OTHER@TIME, or OTHER for when it was nearest to the same place")));
    command.add_option("-o,--output", args.output, help(Text::tr("The HTML file; - is the standard output")))
        ->required();
  }
  if (is("download")) {
    command.add_option("-o,--output", args.output,
                       help(Text::tr("Output file; by default named after the bag")));
    addForce(command, args.force);
  }
  if (is("delete"))
    command.add_flag("--yes", args.yes, help(Text::tr("Required: deleting cannot be undone")));
  if (is("record")) {
    command.add_option("--suffix", args.suffix, help(Text::tr("Part of the bag's name")));
    command.add_option("--duration", args.duration, help(Text::tr("For example 90s or 2m")));
    command.add_option("--category", args.category,
                       help(Text::tr("What to record, in the robot's own terms, for example pos")));
  }
  addJson(command, args.json);
}

}  // namespace

void addBags(Commands& commands) {
  const auto args = std::make_shared<BagsArguments>();
  CLI::App* const bags = commands.program().add_subcommand(
      "bags", help(Text::tr("Bags and recordings of a robot: list, inspect, download, record")));
  bags->require_subcommand(1);
  for (const BagCommand& one : bagCommands()) {
    CLI::App* const command =
        addReading(commands, *bags, one.name, one.about, Text::tr("Robot address (or MAPWRIGHT_ROBOT)"), args,
                   one.run, [](BagsArguments& typed, const Invocation& before) {
                     onRecording(typed.robot, typed.name, before.robot);
                   });
    addBagOptions(one.name, *command, *args);
  }
  addBagPictures(commands, *bags);
}

}  // namespace mapwright::app
