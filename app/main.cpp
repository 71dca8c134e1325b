// mapwright: one binary for the window and its headless twin (cli.md).
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

namespace {

using namespace mapwright;
using app::help;

class MainText {
  Q_DECLARE_TR_FUNCTIONS(CommandLine)
};

struct CommandLine {
  std::string robot, demo_query, file;
  app::AccessWords access;
  app::SnapshotWords snapshot;
  app::MapsWords maps;
  app::ProjectionsWords projections;
  app::BagsWords bags;
  app::FilmWords film;
  app::RecordWords record;
  app::WaypointsWords waypoints;
  app::CloudsWords clouds;
  app::TopicsWords topics;
  app::SimulateWords simulate;
  std::vector<std::string> bench_arguments;
};

std::string layersHelp() {
  QStringList names;
  for (const scene::Layer layer : scene::allLayers()) names << scene::layerName(layer);
  return help(
      MainText::tr("Comma-separated: %1; or all (but track, for which a whole bag is read, and "
                   "dispatched-cloud, which may be large); or none (the map alone). NAME=TOPIC takes a "
                   "grid, a path or a target of a ROS robot from another topic")
          .arg(names.join(QLatin1Char(','))));
}

/// What a picture is asked for with, of a robot or of a bag.
void addSnapshotOptions(CLI::App* command, app::SnapshotWords& words) {
  // No envname(): see addMaps(). What a recording is called tells of a robot, too.
  command->add_option(
      "--robot", words.robot,
      help(MainText::tr("Robot address, for example axbot+http://192.168.25.25:8090 or demo: (or "
                        "MAPWRIGHT_ROBOT)")));
  app::addAccess(*command, words.access);
  command
      ->add_option("-o,--output", words.output,
                   help(MainText::tr("The PNG to write; - is the standard output")))
      ->required();
  command->add_flag("--force", words.force,
                    help(MainText::tr("Write even over a file that the map is read from")));
  command->add_option(
      "--mode", words.mode,
      help(MainText::tr("submaps, or whole (grid: the same for robots and files that give "
                        "their occupancy grid as a whole map). Without it: submaps where there are some")));
  command->add_option(
      "--map", words.map,
      help(MainText::tr(
          "A stored map by its id, or mapping:ID (see mapwright maps list); without it the live or current "
          "one")));
  command->add_flag(
      "--average", words.average,
      help(MainText::tr("Zoomed out, whole maps show the average instead of letting the occupied win")));
  command->add_flag("--robot-anyway", words.robot_anyway,
                    help(MainText::tr("Draw the robot, and what it sees, also on a map that it is not in")));
  command->add_flag("--fit", words.fit, help(MainText::tr("Show everything (the default without --center)")));
  command->add_option(
      "--region", words.region,
      help(MainText::tr(
          "A part of a map that the robot gives by regions (rep130+ws://): X,Y,LX,LY in metres, the "
          "middle and the lengths of the sides. A pixel is a cell, or as large as --scale says")));
  command->add_option("--center", words.center,
                      help(MainText::tr("World point in the middle: X,Y in metres")));
  command->add_option("--scale", words.scale, help(MainText::tr("Metres per pixel")));
  command->add_option("--size", words.size, help(MainText::tr("Picture size: WIDTHxHEIGHT in pixels")))
      ->capture_default_str();
  command->add_option("--rotate", words.rotate_deg,
                      help(MainText::tr("Turn the picture counter-clockwise by this many degrees")));
  command->add_option("--layers", words.layers, layersHelp());
  command->add_option("--resolution", words.resolution,
                      help(MainText::tr("Metres per pixel of a bare picture file")));
  command->add_option(
      "--origin", words.origin,
      help(MainText::tr("Lower left corner of a bare picture file: X,Y or X,Y,YAW in metres and radians")));
  command->add_option("--slice", words.slice, help(MainText::tr("Which slice of each submap")))
      ->capture_default_str();
  command->add_option("--colors", words.colors, help(MainText::tr("normal, incremental or active")))
      ->capture_default_str();
  command->add_option("--theme", words.theme, help(MainText::tr("light or dark")))->capture_default_str();
  command->add_flag("--raw", words.raw,
                    help(MainText::tr("Only the map raster: gray = intensity, alpha 0 = not observed")));
  command
      ->add_option("--settle", words.settle, help(MainText::tr("complete, or how many seconds to collect")))
      ->capture_default_str();
  command
      ->add_option("--timeout", words.timeout_s,
                   help(MainText::tr("Give up waiting after this many seconds")))
      ->capture_default_str();
  command->add_option("--report", words.report,
                      help(MainText::tr("Write what was done as JSON; - is the standard output")));
  command->add_flag("--json", words.json, help(MainText::tr("Print the report on standard output")));
}

void addSnapshot(CLI::App& cli, CommandLine& line) {
  CLI::App* const command =
      cli.add_subcommand("snapshot", help(MainText::tr("Draw a robot's map into a PNG, without a window")));
  addSnapshotOptions(command, line.snapshot);
  command->add_option(
      "--bag", line.snapshot.bag,
      help(MainText::tr("What was recorded, not what is: the name of a bag, or a file (with --at)")));
  command->add_option("--at", line.snapshot.at,
                      help(MainText::tr("When in the bag: seconds since 1970, or 2024-06-03T09:00:00Z")));
}

void addBagSnapshot(CLI::App& bags, CommandLine& line) {
  CLI::App* const command =
      bags.add_subcommand("snapshot", help(MainText::tr("Draw what a bag holds at a time into a PNG")));
  command
      ->add_option("name", line.snapshot.bag, help(MainText::tr("Its name (mapwright bags list), or a file")))
      ->required();
  command
      ->add_option("--at", line.snapshot.at,
                   help(MainText::tr("Seconds since 1970, or 2024-06-03T09:00:00Z")))
      ->required();
  addSnapshotOptions(command, line.snapshot);
}

void addBagFilm(CLI::App& bags, CommandLine& line) {
  CLI::App* const command = bags.add_subcommand(
      "film", help(MainText::tr("Draw what a bag holds, time after time, into PNG files or a film")));
  app::addFilm(*command, line.film);
  addSnapshotOptions(command, line.film.picture);
}

int run(int argc, char** argv) {
  CommandLine line;
  CLI::App cli(
      help(MainText::tr(
          "mapwright: look at the maps of mobile robots. Without a subcommand it opens the window.")),
      "mapwright");
  cli.set_version_flag("--version", std::string("mapwright ") + MAPWRIGHT_VERSION);
  cli.set_help_all_flag("--help-all", help(MainText::tr("Help on every subcommand")));
  cli.require_subcommand(0, 1);
  cli.add_option("--robot", line.robot,
                 help(MainText::tr(
                     "Connect the window to this robot, for example axbot+http://192.168.25.25:8090; "
                     "aimdk+http://HOST?tf=ws://HOST:9090 names an Agibot robot and the rosbridge that tells "
                     "where it is")))
      ->envname("MAPWRIGHT_ROBOT");
  app::addAccess(cli, line.access);
  CLI::App* demo = cli.add_subcommand("demo", help(MainText::tr("Open the window on a simulated robot")));
  demo->add_option("query", line.demo_query,
                   help(MainText::tr("Such as scene=warehouse&submaps=500&seed=3")));
  cli.add_option("file", line.file, help(MainText::tr("A map or a recording (MCAP, bag of ROS 1) to open")));
  CLI::App* play = cli.add_subcommand("play", help(MainText::tr("Open the window on a recording")));
  play->add_option("file", line.file, help(MainText::tr("MCAP, or a bag of ROS 1")))->required();
  app::addSimulate(cli, line.simulate);
  addSnapshot(cli, line);
  app::addMaps(cli, line.maps);
  app::addProjections(cli, line.projections);
  app::addWaypoints(cli, line.waypoints);
  app::addBags(cli, line.bags);
  app::addRecord(cli, line.record);
  app::addClouds(cli, line.clouds);
  app::addTopics(cli, line.topics);
  addBagSnapshot(*cli.get_subcommand("bags"), line);
  addBagFilm(*cli.get_subcommand("bags"), line);
  CLI::App* bench = cli.add_subcommand(
      "bench", help(MainText::tr("Measure against other ways to do the same, in the same run")));
  bench->prefix_command();
  bench->footer(help(MainText::tr(
      "Everything after bench goes to Google Benchmark, for example --benchmark_filter=Compose")));
  bench->set_help_flag();

  app::refuseOddWords(cli);
  try {
    cli.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return cli.exit(error);
    const QString why = QString::fromStdString(words::plainLine(std::string_view(error.what())));
    std::fprintf(stderr, "%s\n", qUtf8Printable(MainText::tr("%1 (see mapwright --help)").arg(why)));
    return app::kUsage;
  }
  if (cli.got_subcommand("simulate")) return app::simulate(line.simulate);
  const bool of_bag = cli.got_subcommand("bags") && cli.get_subcommand("bags")->got_subcommand("snapshot");
  if (cli.got_subcommand("snapshot") || of_bag) {
    app::takeRecording(line.snapshot.robot, line.snapshot.bag, line.robot);
    line.snapshot.access = app::withOuter(line.snapshot.access, line.snapshot.robot, line.access, line.robot);
    return app::snapshot(line.snapshot, argc, argv);
  }
  if (cli.got_subcommand("bags") && cli.get_subcommand("bags")->got_subcommand("film")) {
    app::SnapshotWords& words = line.film.picture;
    app::takeRecording(words.robot, line.film.name, line.robot);
    words.access = app::withOuter(words.access, words.robot, line.access, line.robot);
    return app::bagsFilm(line.film, argc, argv);
  }
  if (cli.got_subcommand("maps")) {
    if (line.maps.robot.empty()) line.maps.robot = line.robot;
    line.maps.access = app::withOuter(line.maps.access, line.maps.robot, line.access, line.robot);
    return app::runMaps(cli, line.maps, argc, argv);
  }
  if (cli.got_subcommand("projections")) {
    app::ProjectionsWords& words = line.projections;
    if (words.robot.empty()) words.robot = line.robot;
    words.access = app::withOuter(words.access, words.robot, line.access, line.robot);
    return app::runProjections(cli, words, argc, argv);
  }
  if (cli.got_subcommand("waypoints")) {
    app::WaypointsWords& words = line.waypoints;
    if (words.robot.empty()) words.robot = line.robot;
    words.access = app::withOuter(words.access, words.robot, line.access, line.robot);
    return app::runWaypoints(cli, words, argc, argv);
  }
  if (cli.got_subcommand("bags")) {
    app::takeRecording(line.bags.robot, line.bags.name, line.robot);
    line.bags.access = app::withOuter(line.bags.access, line.bags.robot, line.access, line.robot);
    return app::runBags(cli, line.bags, argc, argv);
  }
  if (cli.got_subcommand("record")) {
    if (line.record.robot.empty()) line.record.robot = line.robot;
    line.record.access = app::withOuter(line.record.access, line.record.robot, line.access, line.robot);
    return app::record(line.record, argc, argv);
  }
  if (cli.got_subcommand("clouds")) {
    if (line.clouds.robot.empty()) line.clouds.robot = line.robot;
    line.clouds.access = app::withOuter(line.clouds.access, line.clouds.robot, line.access, line.robot);
    return app::runClouds(line.clouds, argc, argv);
  }
  if (cli.got_subcommand("topics")) {
    if (line.topics.robot.empty()) line.topics.robot = line.robot;
    line.topics.access = app::withOuter(line.topics.access, line.topics.robot, line.access, line.robot);
    return app::runTopics(cli, line.topics, argc, argv);
  }
  if (cli.got_subcommand("bench")) return app::bench(bench->remaining());
  if (cli.got_subcommand("demo")) return app::demo(QString::fromStdString(line.demo_query), argc, argv);
  if (line.file.empty()) return app::window(QString::fromStdString(line.robot), line.access, argc, argv);
  const QString file = QString::fromStdString(line.file);
  // A subcommand that is mistyped is no file.
  if (!app::isFileName(file) && !cli.got_subcommand("play")) {
    std::fprintf(stderr, "%s\n",
                 qUtf8Printable(MainText::tr("%1 is neither a subcommand nor a file (see mapwright --help)")
                                    .arg(words::plainName(file))));
    return app::kUsage;
  }
  return app::window(file, line.access, argc, argv);
}

}  // namespace

int main(int argc, char** argv) {
  // What cannot be written is an error with a sentence, not the end of the program.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  app::ignoreRelativeFolders();
  try {
    return app::concludeStandardOutput(run(argc, argv));
  } catch (const std::exception& error) {
    const QString why = QString::fromStdString(words::plainLine(std::string_view(error.what())));
    std::fprintf(stderr, "%s\n", qUtf8Printable(MainText::tr("mapwright had to stop: %1").arg(why)));
    return app::kRobotError;
  }
}
