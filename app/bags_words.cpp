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
  return {{"list", BagsOptionText::tr("All bags and recordings of a robot"), bagsList},
          {"info",
           BagsOptionText::tr(
               "How many messages are in one, of when, and how often they came: the mean from the first "
               "message of a "
               "topic to its last one"),
           bagsInfo},
          {"frames", BagsOptionText::tr("Its messages as recorded, one a line"), bagsFrames},
          {"state", BagsOptionText::tr("The world at a time, as playing it from the start would make it"),
           bagsState},
          {"events",
           BagsOptionText::tr("Alerts, states of the planner, jumps, changes of the map, lost positions"),
           bagsEvents},
          {"download", BagsOptionText::tr("Fetch one into a file, or the rest of one that broke off"),
           bagsDownload},
          {"export", BagsOptionText::tr("A part of one as MCAP or as JSON lines"), bagsExport},
          {"track", BagsOptionText::tr("Where the robot was, as CSV, GeoJSON or TUM"), bagsTrack},
          {"repair",
           BagsOptionText::tr(
               "A recording that was interrupted or is damaged: what is sound of it as a whole MCAP file"),
           bagsRepair},
          {"split",
           BagsOptionText::tr("A recording in parts of equal length, each with what had been said before"),
           bagsSplit},
          {"merge", BagsOptionText::tr("Several recordings as one"), bagsMerge},
          {"delete", BagsOptionText::tr("Delete one on the robot (--yes)"), bagsDelete},
          {"record", BagsOptionText::tr("Let the robot record"), bagsRecord}};
}

void addOptions(const std::string& name, CLI::App& command, BagsWords& words) {
  const auto is = [&](auto... names) { return ((name == names) || ...); };
  const std::string time = help(BagsOptionText::tr("Seconds since 1970, or 2024-06-03T09:00:00Z"));
  if (is("merge"))
    command.add_option("files", words.files, help(BagsOptionText::tr("Recordings on this computer")))
        ->required();
  if (!is("list", "record", "merge"))
    command
        .add_option("name", words.name, help(BagsOptionText::tr("Its name (mapwright bags list), or a file")))
        ->required();
  if (is("frames", "state", "export", "track", "merge")) command.add_option("--from", words.from, time);
  if (is("frames", "export", "track", "merge")) command.add_option("--to", words.to, time);
  if (is("frames", "export", "split", "merge"))
    command
        .add_option("--topic", words.topics,
                    help(BagsOptionText::tr("Only messages of this topic; several with commas between them")))
        ->delimiter(',')
        ->allow_extra_args(false);
  if (is("export", "track")) {
    command
        .add_option("-o,--output", words.output,
                    help(BagsOptionText::tr("The file; - is the standard output")))
        ->required();
    command.add_option(
        "--format", words.format,
        name == "export"
            ? help(BagsOptionText::tr("mcap or jsonl; without it as the file's name ends"))
            : help(BagsOptionText::tr("csv, geojson or tum; without it as the file's name ends")));
    command.add_flag("--force", words.force, help(BagsOptionText::tr("Replace a file that is there")));
  }
  if (is("repair", "split", "merge")) {
    command
        .add_option(
            "-o,--output", words.output,
            is("split")
                ? help(BagsOptionText::tr("The MCAP files, with a number in their name: part-%03d.mcap"))
                : help(BagsOptionText::tr("The MCAP file to write")))
        ->required();
    command.add_flag("--force", words.force, help(BagsOptionText::tr("Replace a file that is there")));
  }
  if (is("split"))
    command.add_option("--every", words.every_s, help(BagsOptionText::tr("Seconds of each part")))
        ->capture_default_str();
  if (is("events"))
    command.add_option("--kind", words.kinds,
                       help(BagsOptionText::tr(
                           "Only these, with commas between them: alerts, planner, position, maps, stops")));
  if (is("state")) command.add_option("--at", words.at, time)->required();
  if (is("download")) {
    command.add_option("-o,--output", words.output,
                       help(BagsOptionText::tr("The file; without it called like the bag")));
    command.add_flag("--force", words.force, help(BagsOptionText::tr("Replace a file that is there")));
  }
  if (is("delete"))
    command.add_flag("--yes", words.yes, help(BagsOptionText::tr("Needed: it cannot be had back")));
  if (is("record")) {
    command.add_option("--suffix", words.suffix, help(BagsOptionText::tr("Of its name")));
    command.add_option("--duration", words.duration, help(BagsOptionText::tr("Such as 90s or 2m")));
    command.add_option("--category", words.category,
                       help(BagsOptionText::tr("The robot's own word, such as pos")));
  }
  addJson(command, words.json);
}

}  // namespace

void addBags(Commands& commands) {
  const auto words = std::make_shared<BagsWords>();
  CLI::App* const bags = commands.program().add_subcommand(
      "bags", help(BagsOptionText::tr("What a robot has recorded: list, look into, fetch, record")));
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
