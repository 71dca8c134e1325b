#include <memory>

#include <CLI/CLI.hpp>
#include <QCoreApplication>

#include "app/bags_film.h"
#include "app/commands.h"
#include "app/option_words.h"
#include "app/recording_operand.h"
#include "app/snapshot.h"
#include "scene/layer.h"

namespace mapwright::app {
namespace {

class SnapshotWordsText {
  Q_DECLARE_TR_FUNCTIONS(CommandLine)
};

QString layersHelp() {
  QStringList names;
  for (const scene::Layer layer : scene::allLayers()) names << scene::layerName(layer);
  return SnapshotWordsText::tr(
             "Layers, separated by commas: %1; or all (except track, which needs a whole bag, and "
             "dispatched-cloud, which may be large); or none (only the map). NAME=TOPIC selects the topic "
             "for a grid, path or target of a ROS robot")
      .arg(names.join(QLatin1Char(',')));
}

/// The options of a picture, of a robot or of a bag.
void addSnapshotOptions(CLI::App* command, SnapshotWords& words) {
  addRobot(*command, words.robot, words.access,
           SnapshotWordsText::tr("Robot address, for example axbot+http://192.168.25.25:8090 or demo: (or "
                                 "MAPWRIGHT_ROBOT)"));
  command
      ->add_option("-o,--output", words.output,
                   help(SnapshotWordsText::tr("The PNG to write; - is the standard output")))
      ->required();
  command->add_flag("--force", words.force,
                    help(SnapshotWordsText::tr("Overwrite a file even if the map was read from it")));
  command->add_option("--mode", words.mode,
                      help(SnapshotWordsText::tr(
                          "submaps, or whole (or grid, which means the same for robots and files whose whole "
                          "map is an occupancy grid). Default: submaps, if there are any")));
  command->add_option("--map", words.map,
                      help(SnapshotWordsText::tr("Id of a stored map, or mapping:ID (see mapwright maps "
                                                 "list); by default the live or current one")));
  command->add_flag(
      "--average", words.average,
      help(SnapshotWordsText::tr(
          "When zoomed out, show the average of the cells of a whole map; by default occupied cells win")));
  command->add_flag(
      "--robot-anyway", words.robot_anyway,
      help(SnapshotWordsText::tr("Draw the robot and its sensor data even on a map that it is not in")));
  command->add_flag("--fit", words.fit,
                    help(SnapshotWordsText::tr("Show the whole map (default without --center)")));
  command->add_option(
      "--region", words.region,
      help(SnapshotWordsText::tr(
          "A part of the map of a robot that sends its map by region (rep130+ws://): X,Y,LX,LY in metres, "
          "its centre and side lengths. A pixel is a cell, or as large as --scale says")));
  command->add_option("--center", words.center,
                      help(SnapshotWordsText::tr("Position at the centre of the picture: X,Y in metres")));
  command->add_option("--scale", words.scale, help(SnapshotWordsText::tr("Metres per pixel")));
  command
      ->add_option("--size", words.size, help(SnapshotWordsText::tr("Picture size: WIDTHxHEIGHT in pixels")))
      ->capture_default_str();
  command->add_option(
      "--rotate", words.rotate_deg,
      help(SnapshotWordsText::tr("Rotate the picture counter-clockwise by this many degrees")));
  command->add_option("--layers", words.layers, help(layersHelp()));
  command->add_option("--resolution", words.resolution,
                      help(SnapshotWordsText::tr("Metres per pixel of a plain picture file")));
  command->add_option(
      "--origin", words.origin,
      help(SnapshotWordsText::tr(
          "Lower left corner of a plain picture file: X,Y or X,Y,YAW in metres and radians")));
  command
      ->add_option("--slice", words.slice, help(SnapshotWordsText::tr("Which slice of each submap to draw")))
      ->capture_default_str();
  command->add_option("--colors", words.colors, help(SnapshotWordsText::tr("normal, incremental or active")))
      ->capture_default_str();
  command->add_option("--theme", words.theme, help(SnapshotWordsText::tr("light or dark")))
      ->capture_default_str();
  command->add_flag(
      "--raw", words.raw,
      help(SnapshotWordsText::tr("Only the map pixels: gray = intensity, alpha 0 = not observed")));
  command
      ->add_option("--settle", words.settle,
                   help(SnapshotWordsText::tr("complete, or for how many seconds to collect data")))
      ->capture_default_str();
  addTimeout(*command, words.timeout_s);
  command->add_option("--report", words.report,
                      help(SnapshotWordsText::tr("Write a summary as JSON; - is the standard output")));
  command->add_flag("--json", words.json, help(SnapshotWordsText::tr("Print the report on standard output")));
}

/// The name of a recording also gives the robot.
int snapshotOf(SnapshotWords& words, const Invocation& before) {
  takeRecording(words.robot, words.bag, before.robot);
  inherit(words.robot, words.access, before);
  return snapshot(words, before.argc, before.argv);
}

}  // namespace

void addSnapshot(Commands& commands) {
  const auto words = std::make_shared<SnapshotWords>();
  CLI::App* const command = commands.program().add_subcommand(
      "snapshot", help(SnapshotWordsText::tr("Draw a robot's map to a PNG, without a window")));
  addSnapshotOptions(command, *words);
  command->add_option(
      "--bag", words->bag,
      help(SnapshotWordsText::tr("Draw recorded data: the name of a bag, or a file (with --at)")));
  command->add_option(
      "--at", words->at,
      help(SnapshotWordsText::tr("Time in the bag: seconds since 1970, or 2024-06-03T09:00:00Z")));
  commands.add(command, [words](const Invocation& before) { return snapshotOf(*words, before); });
}

void addBagPictures(Commands& commands, CLI::App& bags) {
  const auto words = std::make_shared<SnapshotWords>();
  CLI::App* const one = bags.add_subcommand(
      "snapshot", help(SnapshotWordsText::tr("Draw the state of a bag at a given time to a PNG")));
  one->add_option("name", words->bag,
                  help(SnapshotWordsText::tr("Name of the bag (see mapwright bags list), or a file")))
      ->required();
  one->add_option("--at", words->at,
                  help(SnapshotWordsText::tr("Seconds since 1970, or 2024-06-03T09:00:00Z")))
      ->required();
  addSnapshotOptions(one, *words);
  commands.add(one, [words](const Invocation& before) { return snapshotOf(*words, before); });

  const auto film = std::make_shared<FilmWords>();
  CLI::App* const many = bags.add_subcommand(
      "film", help(SnapshotWordsText::tr("Draw a bag at regular times, to PNG files or a video")));
  addFilm(*many, *film);
  addSnapshotOptions(many, film->picture);
  commands.add(many, [film](const Invocation& before) {
    takeRecording(film->picture.robot, film->name, before.robot);
    inherit(film->picture.robot, film->picture.access, before);
    return bagsFilm(*film, before.argc, before.argv);
  });
}

}  // namespace mapwright::app
