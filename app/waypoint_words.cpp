#include <memory>
#include <vector>

#include <CLI/CLI.hpp>
#include <QCoreApplication>

#include "app/commands.h"
#include "app/option_words.h"
#include "app/waypoints.h"

namespace mapwright::app {
namespace {

class WaypointOptionText {
  Q_DECLARE_TR_FUNCTIONS(CommandLine)
};

struct WaypointCommand {
  const char* name;
  QString about;
  int (*run)(const WaypointsWords&, int&, char**);
};

std::vector<WaypointCommand> waypointCommands() {
  return {
      {"list", WaypointOptionText::tr("All waypoints of a map"), waypointsList},
      {"get", WaypointOptionText::tr("One of them"), waypointsGet},
      {"create", WaypointOptionText::tr("Add one"), waypointsCreate},
      {"rename", WaypointOptionText::tr("Call one otherwise"), waypointsRename},
      {"move", WaypointOptionText::tr("Put one elsewhere, or turn it"), waypointsMove},
      {"tag", WaypointOptionText::tr("Change the tags of one"), waypointsTag},
      {"delete", WaypointOptionText::tr("Take some away (--yes)"), waypointsDelete},
      {"import", WaypointOptionText::tr("Add and change those that a file lists; others stay"),
       waypointsImport},
      {"export", WaypointOptionText::tr("Write all of a map as GeoJSON or CSV"), waypointsExport},
      {"plan", WaypointOptionText::tr("What it takes to make the list exactly that of a file; sends nothing"),
       waypointsPlan},
      {"apply", WaypointOptionText::tr("Carry out a plan, merged with what others have changed since"),
       waypointsApply}};
}

/// One of the options, and what it is called there.
void addOptions(const std::string& name, CLI::App& command, WaypointsWords& words) {
  const auto is = [&](auto... names) { return ((name == names) || ...); };
  const std::string which = help(WaypointOptionText::tr("Its id, or its name where no other one has it"));
  if (is("get", "rename", "move", "tag"))
    // One word: a list would take the name behind it, too.
    command
        .add_option_function<std::string>(
            "id", [&words](const std::string& id) { words.which = {id}; }, which)
        ->required();
  if (is("delete"))
    command.add_option("ids", words.which, help(WaypointOptionText::tr("Their ids, or names")))->required();
  if (is("create", "rename"))
    command.add_option("name", words.name, help(WaypointOptionText::tr("Its name from now on")))->required();
  if (is("create", "move"))
    command
        .add_option("--at", words.at,
                    help(WaypointOptionText::tr(
                        "X,Y or X,Y,YAW in metres of the map and degrees, counter-clockwise")))
        ->required();
  if (is("create")) command.add_option("--tags", words.tags, help(WaypointOptionText::tr("Its tags: a,b")));
  if (is("tag")) {
    command.add_option("--set", words.tags, help(WaypointOptionText::tr("Exactly these: a,b")));
    command.add_option("--add", words.added_tags, help(WaypointOptionText::tr("These, too: a,b")));
    command.add_option("--remove", words.removed_tags, help(WaypointOptionText::tr("No longer these: a,b")));
    command.add_flag("--clear", words.no_tags, help(WaypointOptionText::tr("None at all")));
  }
  if (is("delete"))
    command.add_flag("--yes", words.yes, help(WaypointOptionText::tr("Needed: they cannot be had back")));
  if (is("import", "plan"))
    command
        .add_option("file", words.file,
                    help(WaypointOptionText::tr(
                        "F.geojson or F.csv, with the columns of mapwright waypoints list; - is the "
                        "standard input")))
        ->required();
  if (is("apply"))
    command
        .add_option(
            "file", words.file,
            help(WaypointOptionText::tr("What mapwright waypoints plan -o wrote; - is the standard input")))
        ->required();
  if (is("export"))
    command
        .add_option("-o,--output", words.output,
                    help(WaypointOptionText::tr("F.geojson or F.csv; - is the standard output")))
        ->required();
  if (is("plan"))
    command.add_option(
        "-o,--output", words.output,
        help(WaypointOptionText::tr("Where the plan is written, for mapwright waypoints apply; - is the "
                                    "standard output")));
  if (is("list"))
    command.add_flag("--warnings", words.warnings,
                     help(WaypointOptionText::tr(
                         "Also what is doubtful about each: in a wall, outside the map, near a wall, "
                         "a name twice, an orientation of zero")));
  if (is("list", "plan"))
    command.add_option(
        "--radius", words.radius,
        help(WaypointOptionText::tr(
            "Warn of walls that are closer, in metres; without it as the robot tells its shape")));
  if (is("import", "export", "plan"))
    command.add_option(
        "--format", words.format,
        help(WaypointOptionText::tr("csv or geojson, when the name of the file does not tell")));
  if (is("export", "plan"))
    command.add_flag("--force", words.force,
                     help(WaypointOptionText::tr("Write even over a file that the waypoints are read from")));
  if (is("apply"))
    command.add_flag("--force", words.force,
                     help(WaypointOptionText::tr("Also where the plan was not made for")));
  if (is("import", "apply", "delete")) {
    CLI::Option* const stop = command.add_flag(
        "--stop-at-failure", words.stop_at_failure,
        help(WaypointOptionText::tr("Send nothing more after the first request that fails (the default)")));
    command
        .add_flag("--go-on", words.go_on,
                  help(WaypointOptionText::tr("Send the others all the same, unless the link is lost")))
        ->excludes(stop);
  }
  if (!is("list", "get", "export", "plan"))
    command.add_flag("--dry-run", words.dry_run,
                     help(WaypointOptionText::tr("Print what would be done, and send nothing")));
  if (!is("export")) addJson(command, words.json);
}

}  // namespace

void addWaypoints(Commands& commands) {
  const auto words = std::make_shared<WaypointsWords>();
  CLI::App* const waypoints = commands.program().add_subcommand(
      "waypoints",
      help(WaypointOptionText::tr("The waypoints of a map: list, change, import, export, plan, apply")));
  waypoints->require_subcommand(1);
  for (const WaypointCommand& one : waypointCommands()) {
    CLI::App* const command = waypoints->add_subcommand(one.name, help(one.about));
    addRobot(*command, words->robot, words->access,
             WaypointOptionText::tr("Robot address, map.yaml, picture or folder (or MAPWRIGHT_ROBOT)"));
    command->add_option(
        "--map", words->map,
        help(WaypointOptionText::tr("A stored map by its id (mapwright maps list); without it the current "
                                    "one")));
    addTimeout(*command, words->timeout_s);
    addReport(*command, words->report);
    addOptions(one.name, *command, *words);
    commands.add(command, words, one.run);
  }
}

}  // namespace mapwright::app
