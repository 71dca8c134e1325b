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
      {"list", WaypointOptionText::tr("List the waypoints of a map"), waypointsList},
      {"get", WaypointOptionText::tr("Show one waypoint"), waypointsGet},
      {"create", WaypointOptionText::tr("Add a waypoint"), waypointsCreate},
      {"rename", WaypointOptionText::tr("Rename a waypoint"), waypointsRename},
      {"move", WaypointOptionText::tr("Move or turn a waypoint"), waypointsMove},
      {"tag", WaypointOptionText::tr("Change the tags of a waypoint"), waypointsTag},
      {"delete", WaypointOptionText::tr("Delete waypoints (--yes)"), waypointsDelete},
      {"import", WaypointOptionText::tr("Add and update the waypoints listed in a file; others stay"),
       waypointsImport},
      {"export", WaypointOptionText::tr("Write all waypoints of a map as GeoJSON or CSV"), waypointsExport},
      {"plan",
       WaypointOptionText::tr("Work out the changes that make the waypoints match a file; sends nothing"),
       waypointsPlan},
      {"apply", WaypointOptionText::tr("Carry out a plan, merged with changes that others have made since"),
       waypointsApply}};
}

/// Adds the options of a command.
void addOptions(const std::string& name, CLI::App& command, WaypointsWords& words) {
  const auto is = [&](auto... names) { return ((name == names) || ...); };
  const std::string which = help(WaypointOptionText::tr("Its id, or its name if no other waypoint has it"));
  if (is("get", "rename", "move", "tag"))
    // A single value: a list would also take the name after it.
    command
        .add_option_function<std::string>(
            "id", [&words](const std::string& id) { words.which = {id}; }, which)
        ->required();
  if (is("delete"))
    command.add_option("ids", words.which, help(WaypointOptionText::tr("Their ids, or names")))->required();
  if (is("create", "rename"))
    command.add_option("name", words.name, help(WaypointOptionText::tr("New name")))->required();
  if (is("create", "move"))
    command
        .add_option("--at", words.at,
                    help(WaypointOptionText::tr(
                        "X,Y or X,Y,YAW in metres of the map and degrees, counter-clockwise")))
        ->required();
  if (is("create")) command.add_option("--tags", words.tags, help(WaypointOptionText::tr("Tags: a,b")));
  if (is("tag")) {
    command.add_option("--set", words.tags, help(WaypointOptionText::tr("Exactly these tags: a,b")));
    command.add_option("--add", words.added_tags, help(WaypointOptionText::tr("Add these tags: a,b")));
    command.add_option("--remove", words.removed_tags,
                       help(WaypointOptionText::tr("Remove these tags: a,b")));
    command.add_flag("--clear", words.no_tags, help(WaypointOptionText::tr("Remove all tags")));
  }
  if (is("delete"))
    command.add_flag("--yes", words.yes, help(WaypointOptionText::tr("Required: deleting cannot be undone")));
  if (is("import", "plan"))
    command
        .add_option("file", words.file,
                    help(WaypointOptionText::tr(
                        "F.geojson or F.csv, with the columns of mapwright waypoints list; - is the "
                        "standard input")))
        ->required();
  if (is("apply"))
    command
        .add_option("file", words.file,
                    help(WaypointOptionText::tr(
                        "The output of mapwright waypoints plan -o; - is the standard input")))
        ->required();
  if (is("export"))
    command
        .add_option("-o,--output", words.output,
                    help(WaypointOptionText::tr("F.geojson or F.csv; - is the standard output")))
        ->required();
  if (is("plan"))
    command.add_option(
        "-o,--output", words.output,
        help(WaypointOptionText::tr(
            "Where to write the plan for mapwright waypoints apply; - is the standard output")));
  if (is("list"))
    command.add_flag("--warnings", words.warnings,
                     help(WaypointOptionText::tr("Also show possible mistakes: in a wall, outside the map, "
                                                 "near a wall, duplicate name, zero quaternion")));
  if (is("list", "plan"))
    command.add_option("--radius", words.radius,
                       help(WaypointOptionText::tr("Warn of walls that are closer than this, in metres; by "
                                                   "default taken from the robot's footprint")));
  if (is("import", "export", "plan"))
    command.add_option("--format", words.format,
                       help(WaypointOptionText::tr("csv or geojson, if the file name does not say")));
  if (is("export", "plan"))
    command.add_flag(
        "--force", words.force,
        help(WaypointOptionText::tr("Overwrite a file even if the waypoints were read from it")));
  if (is("apply"))
    command.add_flag("--force", words.force,
                     help(WaypointOptionText::tr("Apply it even to a map that the plan was not made for")));
  if (is("import", "apply", "delete")) {
    CLI::Option* const stop =
        command.add_flag("--stop-at-failure", words.stop_at_failure,
                         help(WaypointOptionText::tr("Stop after the first request that fails (default)")));
    command
        .add_flag(
            "--go-on", words.go_on,
            help(WaypointOptionText::tr("Send the remaining ones anyway, unless the connection is lost")))
        ->excludes(stop);
  }
  if (!is("list", "get", "export", "plan"))
    command.add_flag("--dry-run", words.dry_run,
                     help(WaypointOptionText::tr("Print the changes without sending anything")));
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
    command->add_option("--map", words->map,
                        help(WaypointOptionText::tr(
                            "Id of a stored map (see mapwright maps list); by default the current one")));
    addTimeout(*command, words->timeout_s);
    addReport(*command, words->report);
    addOptions(one.name, *command, *words);
    commands.add(command, words, one.run);
  }
}

}  // namespace mapwright::app
