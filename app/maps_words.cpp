#include "app/maps_words.h"

#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <QCoreApplication>

#include "app/access_words.h"
#include "app/maps_change.h"
#include "app/option_words.h"

namespace mapwright::app {
namespace {

class MapsOptionText {
  Q_DECLARE_TR_FUNCTIONS(CommandLine)
};

using robot::MapChange;

/// A `mapwright maps …` that changes something.
struct MapChangeCommand {
  MapChange change;
  const char* name;
  QString about;
  bool of_one_map, names;
};

std::vector<MapChangeCommand> mapChangeCommands() {
  return {
      {MapChange::Rename, "rename", MapsOptionText::tr("Call a stored map otherwise"), true, true},
      {MapChange::Load, "load", MapsOptionText::tr("Make a stored map the one that the robot works with"),
       true, false},
      {MapChange::Archive, "archive", MapsOptionText::tr("Put a stored map away"), true, false},
      {MapChange::Unarchive, "unarchive", MapsOptionText::tr("Take a map out of the archive"), true, false},
      {MapChange::Delete, "delete", MapsOptionText::tr("Delete a stored map (--yes)"), true, false},
      {MapChange::StartMapping, "start-mapping", MapsOptionText::tr("Let the robot begin a new map"), false,
       false},
      {MapChange::StopMapping, "stop-mapping",
       MapsOptionText::tr("End mapping; save keeps what has been mapped"), false, false},
      {MapChange::Save, "save", MapsOptionText::tr("Keep what has been mapped, under a name"), false, true}};
}

}  // namespace

void addMaps(CLI::App& cli, MapsWords& words) {
  CLI::App* maps = cli.add_subcommand(
      "maps",
      help(MapsOptionText::tr("The maps that a robot or a folder keeps: list, export, compare, change")));
  maps->require_subcommand(1);
  const auto addOne = [&](const char* name, const std::string& what) {
    CLI::App* command = maps->add_subcommand(name, what);
    // No envname(): the subcommands share the word, and the variable would be read for those that were not
    // given, over what was typed. It comes from the option before the subcommand.
    command->add_option(
        "--robot", words.robot,
        help(MapsOptionText::tr("Robot address, map.yaml, picture or folder (or MAPWRIGHT_ROBOT)")));
    addAccess(*command, words.access);
    command
        ->add_option("--timeout", words.timeout_s,
                     help(MapsOptionText::tr("Give up waiting after this many seconds")))
        ->capture_default_str();
    command->add_option("--report", words.report,
                        help(MapsOptionText::tr("Write what was done, and every warning, as JSON")));
    return command;
  };
  const auto add = [&](const char* name, const std::string& what) {
    CLI::App* command = addOne(name, what);
    command->add_option(
        "--resolution", words.resolution,
        help(MapsOptionText::tr(
            "Metres per cell: of a bare picture file, or of submaps that are exported or compared (0.05)")));
    command->add_option("--origin", words.origin,
                        help(MapsOptionText::tr("Lower left corner of a bare picture file: X,Y or X,Y,YAW")));
    return command;
  };
  const std::string which = help(MapsOptionText::tr(
      "A stored map by its id, mapping:ID, live, or submaps; without it the live or current one"));
  for (const auto& [name, what] :
       {std::pair{"list", help(MapsOptionText::tr("All maps and mapping results; * marks the current one"))},
        std::pair{"current", help(MapsOptionText::tr("The map that the robot works with"))}}) {
    add(name, what)->add_flag("--json", words.json, help(MapsOptionText::tr("Machine-readable")));
  }
  CLI::App* show = add("show", help(MapsOptionText::tr("Size, place, dates and waypoints of one map")));
  show->add_option("id", words.id, which);
  show->add_flag("--json", words.json, help(MapsOptionText::tr("Machine-readable")));
  CLI::App* exported =
      add("export", help(MapsOptionText::tr("Write a map as PNG, or as PGM and YAML for map_server")));
  exported->add_option("id", words.id, which);
  exported
      ->add_option(
          "-o,--output", words.output,
          help(MapsOptionText::tr(
              "What to write: NAME.png, or NAME.yaml / NAME.pgm (both); - is a PNG on the standard output")))
      ->required();
  exported->add_flag("--force", words.force,
                     help(MapsOptionText::tr("Write even over a file that the map is read from")));
  exported->add_option("--format", words.format,
                       help(MapsOptionText::tr("png or pgm, when the name does not tell")));
  exported->add_flag("--world-file", words.world_file,
                     help(MapsOptionText::tr("Write NAME.pgw (world file) beside it")));
  exported->add_option(
      "--region", words.region,
      help(MapsOptionText::tr("Only this region of the live map, from a map dispatcher (REP 130): "
                              "X,Y,LX,LY, its centre and its lengths in metres")));
  CLI::App* saved =
      addOne("save-on-robot",
             help(MapsOptionText::tr("Let a map dispatcher (REP 130) write its map into a file of its own")));
  saved
      ->add_option(
          "file", words.filename,
          help(MapsOptionText::tr("A name on the robot. Its extension tells the robot what to write: most "
                                  "know .png, .pgm or .yaml of grids and .pcd, .ply or .vtk of clouds")))
      ->required();
  CLI::App* diff =
      add("diff", help(MapsOptionText::tr("Compare two maps cell by cell; exit code 1 when they differ")));
  diff->add_option(
          "first", words.first,
          help(MapsOptionText::tr("A map of --robot (id, mapping:ID, live, submaps), or a file or address")))
      ->required();
  diff->add_option("second", words.second, help(MapsOptionText::tr("Likewise")))->required();
  diff->add_option("--diff", words.diff_picture,
                   help(MapsOptionText::tr("Write the difference as a PNG; - is the standard output")));
  diff->add_flag("--force", words.force,
                 help(MapsOptionText::tr("Write even over a file that a map is read from")));
  diff->add_flag("--json", words.json, help(MapsOptionText::tr("Machine-readable")));
  for (const MapChangeCommand& one : mapChangeCommands()) {
    CLI::App* command = addOne(one.name, help(one.about));
    command->add_flag("--json", words.json, help(MapsOptionText::tr("Machine-readable")));
    if (one.of_one_map)
      command->add_option("id", words.id, help(MapsOptionText::tr("A stored map by its id")))->required();
    if (one.names)
      command->add_option("name", words.label, help(MapsOptionText::tr("Its name from now on")))->required();
    if (one.change == MapChange::Load)
      command->add_option("--waypoint", words.place,
                          help(MapsOptionText::tr("The name of the waypoint where the robot stands")));
    if (one.change == MapChange::Delete)
      command->add_flag("--yes", words.yes, help(MapsOptionText::tr("Needed: it cannot be had back")));
  }
}

int runMaps(const CLI::App& cli, const MapsWords& words, int& argc, char** argv) {
  const CLI::App& maps = *cli.get_subcommand("maps");
  if (maps.got_subcommand("list")) return mapsList(words, argc, argv);
  if (maps.got_subcommand("current")) return mapsCurrent(words, argc, argv);
  if (maps.got_subcommand("show")) return mapsShow(words, argc, argv);
  if (maps.got_subcommand("export")) return mapsExport(words, argc, argv);
  if (maps.got_subcommand("save-on-robot")) return mapsSaveOnRobot(words, argc, argv);
  for (const MapChangeCommand& one : mapChangeCommands()) {
    if (maps.got_subcommand(one.name)) return mapsChange(one.change, words, argc, argv);
  }
  return mapsDiff(words, argc, argv);
}

}  // namespace mapwright::app
