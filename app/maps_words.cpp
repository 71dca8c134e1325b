#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <QCoreApplication>

#include "app/commands.h"
#include "app/maps.h"
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
      {MapChange::Rename, "rename", MapsOptionText::tr("Rename a stored map"), true, true},
      {MapChange::Load, "load", MapsOptionText::tr("Make a stored map the current one"), true, false},
      {MapChange::Archive, "archive", MapsOptionText::tr("Archive a stored map"), true, false},
      {MapChange::Unarchive, "unarchive", MapsOptionText::tr("Restore a map from the archive"), true, false},
      {MapChange::Delete, "delete", MapsOptionText::tr("Delete a stored map (--yes)"), true, false},
      {MapChange::StartMapping, "start-mapping", MapsOptionText::tr("Start mapping"), false, false},
      {MapChange::StopMapping, "stop-mapping", MapsOptionText::tr("End mapping; save stores the result"),
       false, false},
      {MapChange::Save, "save", MapsOptionText::tr("Store the result of mapping under a name"), false, true}};
}

}  // namespace

void addMaps(Commands& commands) {
  const auto shared = std::make_shared<MapsWords>();
  MapsWords& words = *shared;
  CLI::App* maps = commands.program().add_subcommand(
      "maps",
      help(MapsOptionText::tr("Maps stored on a robot or in a folder: list, export, compare, change")));
  maps->require_subcommand(1);
  using Run = std::function<int(const MapsWords&, int&, char**)>;
  const auto addOne = [&](const char* name, const std::string& what, Run run) {
    CLI::App* command = maps->add_subcommand(name, what);
    addRobot(*command, words.robot, words.access,
             MapsOptionText::tr("Robot address, map.yaml, picture or folder (or MAPWRIGHT_ROBOT)"));
    addTimeout(*command, words.timeout_s);
    addReport(*command, words.report);
    commands.add(command, shared, std::move(run));
    return command;
  };
  const auto add = [&](const char* name, const std::string& what, Run run) {
    CLI::App* command = addOne(name, what, std::move(run));
    command->add_option("--resolution", words.resolution,
                        help(MapsOptionText::tr("Metres per cell, for a plain picture file or for submaps "
                                                "that are exported or compared (default: 0.05)")));
    command->add_option(
        "--origin", words.origin,
        help(MapsOptionText::tr("Lower left corner of a plain picture file: X,Y or X,Y,YAW")));
    return command;
  };
  const std::string which = help(MapsOptionText::tr(
      "Id of a stored map, mapping:ID, live, or submaps; by default the live or current one"));
  addJson(*add("list", help(MapsOptionText::tr("List all maps and mapping results; * marks the current one")),
               mapsList),
          words.json);
  addJson(*add("current", help(MapsOptionText::tr("Show the robot's current map")), mapsCurrent), words.json);
  CLI::App* show =
      add("show", help(MapsOptionText::tr("Show size, place, dates and waypoints of a map")), mapsShow);
  show->add_option("id", words.id, which);
  addJson(*show, words.json);
  CLI::App* exported =
      add("export", help(MapsOptionText::tr("Write a map as PNG, or as PGM and YAML for map_server")),
          mapsExport);
  exported->add_option("id", words.id, which);
  exported
      ->add_option("-o,--output", words.output,
                   help(MapsOptionText::tr("Output file: NAME.png, or NAME.yaml / NAME.pgm (both); - writes "
                                           "a PNG to the standard output")))
      ->required();
  exported->add_flag("--force", words.force,
                     help(MapsOptionText::tr("Overwrite a file even if the map was read from it")));
  exported->add_option("--format", words.format,
                       help(MapsOptionText::tr("png or pgm, if the file name does not say")));
  exported->add_flag("--world-file", words.world_file,
                     help(MapsOptionText::tr("Also write NAME.pgw (a world file)")));
  exported->add_option("--region", words.region,
                       help(MapsOptionText::tr("Only this region of the live map of a map dispatcher (REP "
                                               "130): X,Y,LX,LY, its centre and side lengths in metres")));
  CLI::App* saved =
      addOne("save-on-robot",
             help(MapsOptionText::tr("Make a map dispatcher (REP 130) write its map to a file on the robot")),
             mapsSaveOnRobot);
  saved
      ->add_option(
          "file", words.filename,
          help(MapsOptionText::tr("File name on the robot. Its extension selects the format: most know .png, "
                                  ".pgm or .yaml for grids and .pcd, .ply or .vtk for clouds")))
      ->required();
  CLI::App* diff =
      add("diff", help(MapsOptionText::tr("Compare two maps cell by cell; exit code 1 when they differ")),
          mapsDiff);
  diff->add_option(
          "first", words.first,
          help(MapsOptionText::tr("A map of --robot (id, mapping:ID, live, submaps), or a file or address")))
      ->required();
  diff->add_option("second", words.second, help(MapsOptionText::tr("The same for the second map")))
      ->required();
  diff->add_option("--diff", words.diff_picture,
                   help(MapsOptionText::tr("Write the differences as a PNG; - is the standard output")));
  diff->add_flag("--force", words.force,
                 help(MapsOptionText::tr("Overwrite a file even if a map was read from it")));
  addJson(*diff, words.json);
  for (const MapChangeCommand& one : mapChangeCommands()) {
    CLI::App* command = addOne(one.name, help(one.about),
                               [change = one.change](const MapsWords& typed, int& argc, char** argv) {
                                 return mapsChange(change, typed, argc, argv);
                               });
    addJson(*command, words.json);
    if (one.of_one_map)
      command->add_option("id", words.id, help(MapsOptionText::tr("Id of a stored map")))->required();
    if (one.names) command->add_option("name", words.label, help(MapsOptionText::tr("New name")))->required();
    if (one.change == MapChange::Load)
      command->add_option("--waypoint", words.place,
                          help(MapsOptionText::tr("Name of the waypoint at which the robot stands")));
    if (one.change == MapChange::Delete)
      command->add_flag("--yes", words.yes, help(MapsOptionText::tr("Required: deleting cannot be undone")));
  }
}

}  // namespace mapwright::app
