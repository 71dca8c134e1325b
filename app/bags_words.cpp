#include <vector>

#include <CLI/CLI.hpp>
#include <QCoreApplication>

#include "app/bags.h"
#include "app/commands.h"
#include "app/option_words.h"
#include "app/recording_operand.h"
#include "app/snapshot.h"

namespace mapwright::app {
namespace {

class BagsOptionText {
  Q_DECLARE_TR_FUNCTIONS(CommandLine)
};

struct BagCommand {
  const char* name;
  QString about;
  int (*run)(const BagsWords&, int&, char**);
};

std::vector<BagCommand> bagCommands() {
  return {
      {"list", BagsOptionText::tr("List the bags and recordings of a robot"), bagsList},
      {"info",
       BagsOptionText::tr("Count the messages, with their time span and rates (the mean between the first "
                          "and the last message of a topic)"),
       bagsInfo},
      {"frames", BagsOptionText::tr("Print the messages as recorded, one per line"), bagsFrames},
      {"state",
       BagsOptionText::tr("Show the state at a given time, as replaying from the start would give it"),
       bagsState},
      {"events",
       BagsOptionText::tr("List alerts, planner states, position jumps, map changes and lost localization"),
       bagsEvents},
      {"download", BagsOptionText::tr("Download one to a file, or resume an interrupted download"),
       bagsDownload},
      {"export", BagsOptionText::tr("Export a part as MCAP or JSON lines"), bagsExport},
      {"track", BagsOptionText::tr("Export the robot's path as CSV, GeoJSON or TUM"), bagsTrack},
      {"repair",
       BagsOptionText::tr("Recover what is intact in an interrupted or damaged recording and write it as a "
                          "complete MCAP file"),
       bagsRepair},
      {"split",
       BagsOptionText::tr("Split a recording into parts of equal length that can each be replayed alone"),
       bagsSplit},
      {"merge", BagsOptionText::tr("Merge several recordings into one"), bagsMerge},
      {"delete", BagsOptionText::tr("Delete one from the robot (--yes)"), bagsDelete},
      {"record", BagsOptionText::tr("Make the robot record a bag"), bagsRecord}};
}

void addOptions(const std::string& name, CLI::App& command, BagsWords& words) {
  const auto is = [&](auto... names) { return ((name == names) || ...); };
  const std::string time = help(BagsOptionText::tr("Seconds since 1970, or 2024-06-03T09:00:00Z"));
  if (is("merge"))
    command.add_option("files", words.files, help(BagsOptionText::tr("Recordings on this computer")))
        ->required();
  if (!is("list", "record", "merge"))
    command
        .add_option("name", words.name,
                    help(BagsOptionText::tr("Name of the bag (see mapwright bags list), or a file")))
        ->required();
  if (is("frames", "state", "export", "track", "merge")) command.add_option("--from", words.from, time);
  if (is("frames", "export", "track", "merge")) command.add_option("--to", words.to, time);
  if (is("frames", "export", "split", "merge"))
    command
        .add_option("--topic", words.topics,
                    help(BagsOptionText::tr("Only messages of this topic; separate several with commas")))
        ->delimiter(',')
        ->allow_extra_args(false);
  if (is("export", "track")) {
    command
        .add_option("-o,--output", words.output,
                    help(BagsOptionText::tr("Output file; - is the standard output")))
        ->required();
    command.add_option(
        "--format", words.format,
        name == "export"
            ? help(BagsOptionText::tr("mcap or jsonl; by default taken from the file name"))
            : help(BagsOptionText::tr("csv, geojson or tum; by default taken from the file name")));
    command.add_flag("--force", words.force, help(BagsOptionText::tr("Replace an existing file")));
  }
  if (is("repair", "split", "merge")) {
    command
        .add_option("-o,--output", words.output,
                    is("split")
                        ? help(BagsOptionText::tr("Names of the MCAP files, with a number: part-%03d.mcap"))
                        : help(BagsOptionText::tr("The MCAP file to write")))
        ->required();
    command.add_flag("--force", words.force, help(BagsOptionText::tr("Replace an existing file")));
  }
  if (is("split"))
    command.add_option("--every", words.every_s, help(BagsOptionText::tr("Length of each part in seconds")))
        ->capture_default_str();
  if (is("events"))
    command.add_option(
        "--kind", words.kinds,
        help(BagsOptionText::tr("Only these, separated by commas: alerts, planner, position, maps, stops")));
  if (is("state")) command.add_option("--at", words.at, time)->required();
  if (is("download")) {
    command.add_option("-o,--output", words.output,
                       help(BagsOptionText::tr("Output file; by default named after the bag")));
    command.add_flag("--force", words.force, help(BagsOptionText::tr("Replace an existing file")));
  }
  if (is("delete"))
    command.add_flag("--yes", words.yes, help(BagsOptionText::tr("Required: deleting cannot be undone")));
  if (is("record")) {
    command.add_option("--suffix", words.suffix, help(BagsOptionText::tr("Part of the bag's name")));
    command.add_option("--duration", words.duration, help(BagsOptionText::tr("For example 90s or 2m")));
    command.add_option("--category", words.category,
                       help(BagsOptionText::tr("What to record, in the robot's own terms, for example pos")));
  }
  addJson(command, words.json);
}

}  // namespace

void addBags(Commands& commands) {
  const auto words = std::make_shared<BagsWords>();
  CLI::App* const bags = commands.program().add_subcommand(
      "bags", help(BagsOptionText::tr("Bags and recordings of a robot: list, inspect, download, record")));
  bags->require_subcommand(1);
  for (const BagCommand& one : bagCommands()) {
    CLI::App* const command = bags->add_subcommand(one.name, help(one.about));
    addRobot(*command, words->robot, words->access, BagsOptionText::tr("Robot address (or MAPWRIGHT_ROBOT)"));
    addTimeout(*command, words->timeout_s);
    addReport(*command, words->report);
    addOptions(one.name, *command, *words);
    commands.add(command, [words, run = one.run](const Invocation& before) {
      takeRecording(words->robot, words->name, before.robot);
      inherit(words->robot, words->access, before);
      return run(*words, before.argc, before.argv);
    });
  }
  addBagPictures(commands, *bags);
}

}  // namespace mapwright::app
