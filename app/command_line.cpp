#include "app/command_line.h"

#include <csignal>
#include <cstdio>
#include <exception>
#include <string>

#include <CLI/CLI.hpp>
#include <QCoreApplication>

#include "app/access_words.h"
#include "app/bags_film.h"
#include "app/bags_words.h"
#include "app/bench_program.h"
#include "app/clouds.h"
#include "app/exit_code.h"
#include "app/maps_words.h"
#include "app/option_words.h"
#include "app/output_paths.h"
#include "app/projections.h"
#include "app/record.h"
#include "app/recording_operand.h"
#include "app/simulate.h"
#include "app/simulate_options.h"
#include "app/snapshot.h"
#include "app/topics.h"
#include "app/waypoint_words.h"
#include "app/window.h"
#include "app/xdg.h"
#include "scene/layer.h"
#include "words/plain.h"
#include "words/qt_plain.h"

namespace mapwright::app {
namespace {

class CommandLineText {
  Q_DECLARE_TR_FUNCTIONS(CommandLine)
};

struct CommandLine {
  std::string robot, demo_query, file;
  AccessWords access;
  SnapshotWords snapshot;
  MapsWords maps;
  ProjectionsWords projections;
  BagsWords bags;
  FilmWords film;
  RecordWords record;
  WaypointsWords waypoints;
  CloudsWords clouds;
  TopicsWords topics;
  SimulateWords simulate;
  std::vector<std::string> bench_arguments;
};

QString layersHelp() {
  QStringList names;
  for (const scene::Layer layer : scene::allLayers()) names << scene::layerName(layer);
  return CommandLineText::tr(
             "Comma-separated: %1; or all (but track, for which a whole bag is read, and "
             "dispatched-cloud, which may be large); or none (the map alone). NAME=TOPIC takes a "
             "grid, a path or a target of a ROS robot from another topic")
      .arg(names.join(QLatin1Char(',')));
}

/// What a picture is asked for with, of a robot or of a bag.
void addSnapshotOptions(CLI::App* command, SnapshotWords& words) {
  // No envname(): see addMaps(). What a recording is called tells of a robot, too.
  command->add_option(
      "--robot", words.robot,
      help(CommandLineText::tr("Robot address, for example axbot+http://192.168.25.25:8090 or demo: (or "
                               "MAPWRIGHT_ROBOT)")));
  addAccess(*command, words.access);
  command
      ->add_option("-o,--output", words.output,
                   help(CommandLineText::tr("The PNG to write; - is the standard output")))
      ->required();
  command->add_flag("--force", words.force,
                    help(CommandLineText::tr("Write even over a file that the map is read from")));
  command->add_option("--mode", words.mode,
                      help(CommandLineText::tr(
                          "submaps, or whole (grid: the same for robots and files that give "
                          "their occupancy grid as a whole map). Without it: submaps where there are some")));
  command->add_option(
      "--map", words.map,
      help(CommandLineText::tr(
          "A stored map by its id, or mapping:ID (see mapwright maps list); without it the live or current "
          "one")));
  command->add_flag("--average", words.average,
                    help(CommandLineText::tr(
                        "Zoomed out, whole maps show the average instead of letting the occupied win")));
  command->add_flag(
      "--robot-anyway", words.robot_anyway,
      help(CommandLineText::tr("Draw the robot, and what it sees, also on a map that it is not in")));
  command->add_flag("--fit", words.fit,
                    help(CommandLineText::tr("Show everything (the default without --center)")));
  command->add_option(
      "--region", words.region,
      help(CommandLineText::tr(
          "A part of a map that the robot gives by regions (rep130+ws://): X,Y,LX,LY in metres, the "
          "middle and the lengths of the sides. A pixel is a cell, or as large as --scale says")));
  command->add_option("--center", words.center,
                      help(CommandLineText::tr("World point in the middle: X,Y in metres")));
  command->add_option("--scale", words.scale, help(CommandLineText::tr("Metres per pixel")));
  command->add_option("--size", words.size, help(CommandLineText::tr("Picture size: WIDTHxHEIGHT in pixels")))
      ->capture_default_str();
  command->add_option("--rotate", words.rotate_deg,
                      help(CommandLineText::tr("Turn the picture counter-clockwise by this many degrees")));
  command->add_option("--layers", words.layers, help(layersHelp()));
  command->add_option("--resolution", words.resolution,
                      help(CommandLineText::tr("Metres per pixel of a bare picture file")));
  command->add_option("--origin", words.origin,
                      help(CommandLineText::tr(
                          "Lower left corner of a bare picture file: X,Y or X,Y,YAW in metres and radians")));
  command->add_option("--slice", words.slice, help(CommandLineText::tr("Which slice of each submap")))
      ->capture_default_str();
  command->add_option("--colors", words.colors, help(CommandLineText::tr("normal, incremental or active")))
      ->capture_default_str();
  command->add_option("--theme", words.theme, help(CommandLineText::tr("light or dark")))
      ->capture_default_str();
  command->add_flag(
      "--raw", words.raw,
      help(CommandLineText::tr("Only the map raster: gray = intensity, alpha 0 = not observed")));
  command
      ->add_option("--settle", words.settle,
                   help(CommandLineText::tr("complete, or how many seconds to collect")))
      ->capture_default_str();
  command
      ->add_option("--timeout", words.timeout_s,
                   help(CommandLineText::tr("Give up waiting after this many seconds")))
      ->capture_default_str();
  command->add_option("--report", words.report,
                      help(CommandLineText::tr("Write what was done as JSON; - is the standard output")));
  command->add_flag("--json", words.json, help(CommandLineText::tr("Print the report on standard output")));
}

void addSnapshot(CLI::App& cli, CommandLine& line) {
  CLI::App* const command = cli.add_subcommand(
      "snapshot", help(CommandLineText::tr("Draw a robot's map into a PNG, without a window")));
  addSnapshotOptions(command, line.snapshot);
  command->add_option(
      "--bag", line.snapshot.bag,
      help(CommandLineText::tr("What was recorded, not what is: the name of a bag, or a file (with --at)")));
  command->add_option(
      "--at", line.snapshot.at,
      help(CommandLineText::tr("When in the bag: seconds since 1970, or 2024-06-03T09:00:00Z")));
}

void addBagSnapshot(CLI::App& bags, CommandLine& line) {
  CLI::App* const command = bags.add_subcommand(
      "snapshot", help(CommandLineText::tr("Draw what a bag holds at a time into a PNG")));
  command
      ->add_option("name", line.snapshot.bag,
                   help(CommandLineText::tr("Its name (mapwright bags list), or a file")))
      ->required();
  command
      ->add_option("--at", line.snapshot.at,
                   help(CommandLineText::tr("Seconds since 1970, or 2024-06-03T09:00:00Z")))
      ->required();
  addSnapshotOptions(command, line.snapshot);
}

void addBagFilm(CLI::App& bags, CommandLine& line) {
  CLI::App* const command = bags.add_subcommand(
      "film", help(CommandLineText::tr("Draw what a bag holds, time after time, into PNG files or a film")));
  addFilm(*command, line.film);
  addSnapshotOptions(command, line.film.picture);
}

int runCommand(int argc, char** argv) {
  CommandLine line;
  CLI::App cli(
      help(CommandLineText::tr(
          "mapwright: look at the maps of mobile robots. Without a subcommand it opens the window.")),
      "mapwright");
  cli.set_version_flag("--version", std::string("mapwright ") + MAPWRIGHT_VERSION);
  cli.set_help_all_flag("--help-all", help(CommandLineText::tr("Help on every subcommand")));
  cli.require_subcommand(0, 1);
  cli.add_option("--robot", line.robot,
                 help(CommandLineText::tr(
                     "Connect the window to this robot, for example axbot+http://192.168.25.25:8090; "
                     "aimdk+http://HOST?tf=ws://HOST:9090 names an Agibot robot and the rosbridge that tells "
                     "where it is")))
      ->envname("MAPWRIGHT_ROBOT");
  addAccess(cli, line.access);
  CLI::App* demo =
      cli.add_subcommand("demo", help(CommandLineText::tr("Open the window on a simulated robot")));
  demo->add_option("query", line.demo_query,
                   help(CommandLineText::tr("Such as scene=warehouse&submaps=500&seed=3")));
  cli.add_option("file", line.file,
                 help(CommandLineText::tr("A map or a recording (MCAP, bag of ROS 1) to open")));
  CLI::App* play = cli.add_subcommand("play", help(CommandLineText::tr("Open the window on a recording")));
  play->add_option("file", line.file, help(CommandLineText::tr("MCAP, or a bag of ROS 1")))->required();
  addSimulate(cli, line.simulate);
  addSnapshot(cli, line);
  addMaps(cli, line.maps);
  addProjections(cli, line.projections);
  addWaypoints(cli, line.waypoints);
  addBags(cli, line.bags);
  addRecord(cli, line.record);
  addClouds(cli, line.clouds);
  addTopics(cli, line.topics);
  addBagSnapshot(*cli.get_subcommand("bags"), line);
  addBagFilm(*cli.get_subcommand("bags"), line);
  CLI::App* bench = cli.add_subcommand(
      "bench", help(CommandLineText::tr("Measure against other ways to do the same, in the same run")));
  bench->prefix_command();
  bench->footer(help(CommandLineText::tr(
      "Everything after bench goes to Google Benchmark, for example --benchmark_filter=Compose")));
  bench->set_help_flag();

  refuseOddWords(cli);
  try {
    cli.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return cli.exit(error);
    const QString why = QString::fromStdString(words::plainLine(std::string_view(error.what())));
    std::fprintf(stderr, "%s\n", qUtf8Printable(CommandLineText::tr("%1 (see mapwright --help)").arg(why)));
    return kUsage;
  }
  if (cli.got_subcommand("simulate")) return simulate(line.simulate);
  const bool of_bag = cli.got_subcommand("bags") && cli.get_subcommand("bags")->got_subcommand("snapshot");
  if (cli.got_subcommand("snapshot") || of_bag) {
    takeRecording(line.snapshot.robot, line.snapshot.bag, line.robot);
    line.snapshot.access = withOuter(line.snapshot.access, line.snapshot.robot, line.access, line.robot);
    return snapshot(line.snapshot, argc, argv);
  }
  if (cli.got_subcommand("bags") && cli.get_subcommand("bags")->got_subcommand("film")) {
    SnapshotWords& words = line.film.picture;
    takeRecording(words.robot, line.film.name, line.robot);
    words.access = withOuter(words.access, words.robot, line.access, line.robot);
    return bagsFilm(line.film, argc, argv);
  }
  if (cli.got_subcommand("maps")) {
    if (line.maps.robot.empty()) line.maps.robot = line.robot;
    line.maps.access = withOuter(line.maps.access, line.maps.robot, line.access, line.robot);
    return runMaps(cli, line.maps, argc, argv);
  }
  if (cli.got_subcommand("projections")) {
    ProjectionsWords& words = line.projections;
    if (words.robot.empty()) words.robot = line.robot;
    words.access = withOuter(words.access, words.robot, line.access, line.robot);
    return runProjections(cli, words, argc, argv);
  }
  if (cli.got_subcommand("waypoints")) {
    WaypointsWords& words = line.waypoints;
    if (words.robot.empty()) words.robot = line.robot;
    words.access = withOuter(words.access, words.robot, line.access, line.robot);
    return runWaypoints(cli, words, argc, argv);
  }
  if (cli.got_subcommand("bags")) {
    takeRecording(line.bags.robot, line.bags.name, line.robot);
    line.bags.access = withOuter(line.bags.access, line.bags.robot, line.access, line.robot);
    return runBags(cli, line.bags, argc, argv);
  }
  if (cli.got_subcommand("record")) {
    if (line.record.robot.empty()) line.record.robot = line.robot;
    line.record.access = withOuter(line.record.access, line.record.robot, line.access, line.robot);
    return record(line.record, argc, argv);
  }
  if (cli.got_subcommand("clouds")) {
    if (line.clouds.robot.empty()) line.clouds.robot = line.robot;
    line.clouds.access = withOuter(line.clouds.access, line.clouds.robot, line.access, line.robot);
    return runClouds(line.clouds, argc, argv);
  }
  if (cli.got_subcommand("topics")) {
    if (line.topics.robot.empty()) line.topics.robot = line.robot;
    line.topics.access = withOuter(line.topics.access, line.topics.robot, line.access, line.robot);
    return runTopics(cli, line.topics, argc, argv);
  }
  if (cli.got_subcommand("bench")) return app::bench(bench->remaining());
  if (cli.got_subcommand("demo")) return app::demo(QString::fromStdString(line.demo_query), argc, argv);
  if (line.file.empty()) return window(QString::fromStdString(line.robot), line.access, argc, argv);
  const QString file = QString::fromStdString(line.file);
  // A subcommand that is mistyped is no file.
  if (!isFileName(file) && !cli.got_subcommand("play")) {
    std::fprintf(
        stderr, "%s\n",
        qUtf8Printable(CommandLineText::tr("%1 is neither a subcommand nor a file (see mapwright --help)")
                           .arg(words::plainName(file))));
    return kUsage;
  }
  return window(file, line.access, argc, argv);
}

}  // namespace

int commandLine(int argc, char** argv) {
  // What cannot be written is an error with a sentence, not the end of the program.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  ignoreRelativeFolders();
  try {
    return concludeStandardOutput(runCommand(argc, argv));
  } catch (const std::exception& error) {
    const QString why = QString::fromStdString(words::plainLine(std::string_view(error.what())));
    std::fprintf(stderr, "%s\n", qUtf8Printable(CommandLineText::tr("mapwright had to stop: %1").arg(why)));
    return kRobotError;
  }
}

}  // namespace mapwright::app
