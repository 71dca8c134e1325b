// mapwright: one binary for the window and its headless twin (cli.md).
#include <csignal>
#include <cstdio>
#include <exception>
#include <string>

#include <CLI/CLI.hpp>
#include <QCoreApplication>

#include "app/access_words.h"
#include "app/bench_program.h"
#include "app/exit_code.h"
#include "app/maps_words.h"
#include "app/option_words.h"
#include "app/output_paths.h"
#include "app/simulate.h"
#include "app/snapshot.h"
#include "app/waypoint_words.h"
#include "app/window.h"
#include "app/xdg.h"
#include "scene/layer.h"
#include "words/plain.h"

namespace {

using namespace mapwright;

class Words {
  Q_DECLARE_TR_FUNCTIONS(CommandLine)
};

/// What --help says, as CLI11 takes it.
std::string help(const QString& text) { return text.toStdString(); }

struct CommandLine {
  std::string robot, demo_query;
  app::AccessWords access;
  app::SnapshotWords snapshot;
  app::MapsWords maps;
  app::WaypointsWords waypoints;
  app::SimulateWords simulate;
  std::vector<std::string> bench_arguments;
};

std::string layersHelp() {
  QStringList names;
  for (const scene::Layer layer : scene::allLayers()) names << scene::layerName(layer);
  return help(
      Words::tr("Comma-separated: %1; or all; or none (the map alone)").arg(names.join(QLatin1Char(','))));
}

void addSnapshot(CLI::App& cli, CommandLine& line) {
  CLI::App* command =
      cli.add_subcommand("snapshot", help(Words::tr("Draw a robot's map into a PNG, without a window")));
  app::SnapshotWords& words = line.snapshot;
  command
      ->add_option("--robot", words.robot,
                   help(Words::tr("Robot address, for example axbot+http://192.168.25.25:8090 or demo:")))
      ->envname("MAPWRIGHT_ROBOT");
  app::addAccess(*command, words.access);
  command
      ->add_option("-o,--output", words.output, help(Words::tr("The PNG to write; - is the standard output")))
      ->required();
  command->add_flag("--force", words.force,
                    help(Words::tr("Write even over a file that the map is read from")));
  command->add_option(
      "--mode", words.mode,
      help(Words::tr("submaps, or whole (grid: the same for robots and files that give "
                     "their occupancy grid as a whole map). Without it: submaps where there are some")));
  command->add_option(
      "--map", words.map,
      help(Words::tr(
          "A stored map by its id, or mapping:ID (see mapwright maps list); without it the live or current "
          "one")));
  command->add_flag(
      "--average", words.average,
      help(Words::tr("Zoomed out, whole maps show the average instead of letting the occupied win")));
  command->add_flag("--robot-anyway", words.robot_anyway,
                    help(Words::tr("Draw the robot, and what it sees, also on a map that it is not in")));
  command->add_flag("--fit", words.fit, help(Words::tr("Show everything (the default without --center)")));
  command->add_option("--center", words.center, help(Words::tr("World point in the middle: X,Y in metres")));
  command->add_option("--scale", words.scale, help(Words::tr("Metres per pixel")));
  command->add_option("--size", words.size, help(Words::tr("Picture size: WIDTHxHEIGHT in pixels")))
      ->capture_default_str();
  command->add_option("--rotate", words.rotate_deg,
                      help(Words::tr("Turn the picture counter-clockwise by this many degrees")));
  command->add_option("--layers", words.layers, layersHelp());
  command->add_option("--resolution", words.resolution,
                      help(Words::tr("Metres per pixel of a bare picture file")));
  command->add_option(
      "--origin", words.origin,
      help(Words::tr("Lower left corner of a bare picture file: X,Y or X,Y,YAW in metres and radians")));
  command->add_option("--slice", words.slice, help(Words::tr("Which slice of each submap")))
      ->capture_default_str();
  command->add_option("--colors", words.colors, help(Words::tr("normal, incremental or active")))
      ->capture_default_str();
  command->add_option("--theme", words.theme, help(Words::tr("light or dark")))->capture_default_str();
  command->add_flag("--raw", words.raw,
                    help(Words::tr("Only the map raster: gray = intensity, alpha 0 = not observed")));
  command->add_option("--settle", words.settle, help(Words::tr("complete, or how many seconds to collect")))
      ->capture_default_str();
  command
      ->add_option("--timeout", words.timeout_s, help(Words::tr("Give up waiting after this many seconds")))
      ->capture_default_str();
  command->add_option("--report", words.report,
                      help(Words::tr("Write what was done as JSON; - is the standard output")));
  command->add_flag("--json", words.json, help(Words::tr("Print the report on standard output")));
}

void addSimulate(CLI::App& cli, CommandLine& line) {
  std::string scenes;
  for (const auto& [name, sentence] : simulator::sceneNames()) scenes += (scenes.empty() ? "" : ", ") + name;
  CLI::App* command = cli.add_subcommand("simulate", help(Words::tr("Serve a simulated robot on 127.0.0.1")));
  simulator::Options& o = line.simulate.options;
  command->add_option("--port", o.port, help(Words::tr("Port of the Autoxing robot, 0 = a free one")))
      ->capture_default_str();
  command
      ->add_option("--aimdk-port", o.aimdk_port, help(Words::tr("Port of the Agibot robot, 0 = a free one")))
      ->capture_default_str();
  command->add_option("--scene", o.scene, help(Words::tr("One of: %1").arg(QString::fromStdString(scenes))))
      ->capture_default_str()
      ->check([](const std::string& s) {
        for (const auto& [name, sentence] : simulator::sceneNames()) {
          if (name == s) return std::string();
        }
        return help(Words::tr("there is no scene \"%1\"").arg(QString::fromStdString(s)));
      });
  command
      ->add_option(
          "--submaps", o.submaps,
          help(Words::tr(
              "About how many submaps (0 = as the scene has); beyond 20,000 they share 256 pictures")))
      ->check(CLI::Range(0, 100'000));
  command->add_option("--seed", o.seed, help(Words::tr("Everything random follows from this")))
      ->capture_default_str();
  command->add_option("--speed", o.speed, help(Words::tr("Simulated seconds per second")))
      ->check(CLI::Range(0.0, 1000.0));
  command->add_option("--start-at", o.start_at_s, help(Words::tr("Simulated time at start, seconds")))
      ->check(CLI::Range(0.0, 1e6));
  command->add_flag("--paused", o.paused, help(Words::tr("Let simulated time stand still")));
  command->add_option(
      "--secret-file", line.simulate.secret_file,
      help(Words::tr("File that holds the secret without which the Autoxing robot answers 401")));
  command->add_flag("!--no-topic-lists", o.enable_topic_list,
                    help(Words::tr("Understand enable_topic one by one only")));
  command->add_flag("!--no-binary", o.binary_topics, help(Words::tr("Ignore ?pb=1")));
  command->add_option("--points", o.points_per_scan, help(Words::tr("Lidar points in a scan")))
      ->check(CLI::Range(0, 1'000'000))
      ->capture_default_str();
  command->add_option("--scan-hz", o.scan_hz, help(Words::tr("Scans per second")))
      ->check(CLI::Range(0.1, 100.0))
      ->capture_default_str();
  command->add_option("--pose-hz", o.pose_hz, help(Words::tr("Poses per second")))
      ->check(CLI::Range(0.1, 100.0))
      ->capture_default_str();
  command
      ->add_option("--costmap-cells", o.costmap_cells,
                   help(Words::tr("Edge of the costmaps around the robot, cells")))
      ->check(CLI::Range(20, 4000))
      ->capture_default_str();
  simulator::Faults& f = o.faults;
  const std::string faults = help(Words::tr("Faults"));
  const auto rate = [&](const char* name, double& value, const std::string& what) {
    command->add_option(name, value, what)->check(CLI::Range(0.0, 1.0))->group(faults);
  };
  const auto count = [&](const char* name, int& value, const std::string& what, int limit) {
    command->add_option(name, value, what)->check(CLI::Range(0, limit))->group(faults);
  };
  count("--latency-ms", f.latency_ms, help(Words::tr("Delay of every submap answer")), 600'000);
  count("--jitter-ms", f.jitter_ms, help(Words::tr("Random addition to the delay")), 600'000);
  rate("--drop-rate", f.drop_rate, help(Words::tr("Share of submap requests dropped without an answer")));
  rate("--truncate-rate", f.truncate_rate, help(Words::tr("Share of answers cut off half-way")));
  rate("--wrong-size-rate", f.wrong_size_rate,
       help(Words::tr("Share of answers whose width and height do not fit the cells")));
  rate("--corrupt-rate", f.corrupt_rate, help(Words::tr("Share of answers that are garbage")));
  rate("--error-rate", f.error_rate, help(Words::tr("Share of answers with --error-status")));
  command->add_option("--error-status", f.error_status, help(Words::tr("HTTP status of those errors")))
      ->check(CLI::IsMember({400, 404, 500, 502, 504}))
      ->group(faults);
  rate("--status-code-rate", f.status_code_rate,
       help(Words::tr("Share of HTTP 200 answers whose own status is an error")));
  count("--websocket-drop-every", f.websocket_drop_every_s,
        help(Words::tr("Cut the WebSocket every so many seconds")), 86'400);
  count("--uuid-change-every", f.uuid_change_every_s, help(Words::tr("Restart SLAM every so many seconds")),
        86'400);
  command
      ->add_flag("--bad-entries", f.bad_entries,
                 help(Words::tr("List NaN poses, zero quaternions, duplicates, versions going back")))
      ->group(faults);
  command
      ->add_flag("--silent-websocket", f.silent_websocket,
                 help(Words::tr("Accept the WebSocket, then say nothing")))
      ->group(faults);
  count("--write-latency-ms", f.write_latency_ms,
        help(Words::tr("Delay of every answer to POST, PUT, PATCH and DELETE")), 600'000);
  rate("--write-error-rate", f.write_error_rate,
       help(Words::tr("Share of those that change nothing and get 500, 502 or 503")));
  rate("--drop-writes", f.drop_writes,
       help(Words::tr("Share of those that change nothing and get no answer")));
  rate("--lose-write-answers", f.lose_write_answers,
       help(Words::tr("Share of those that are carried out but get no answer")));
  count("--map-latency-ms", f.map_latency_ms, help(Words::tr("Delay of every answer about maps")), 600'000);
  const auto flag = [&](const char* name, bool& value, const std::string& what) {
    command->add_flag(name, value, what)->group(faults);
  };
  flag("--truncated-maps", f.truncated_maps, help(Words::tr("Cut every map's PNG in half")));
  flag("--lying-map-size", f.lying_map_size,
       help(Words::tr("Every map's PNG declares 60,000 x 60,000 pixels")));
  flag("--foreign-data-url", f.foreign_data_url, help(Words::tr("data_url points to another host")));
  flag("--garbage-base64", f.garbage_base64, help(Words::tr("Pictures in topics are no base64")));
  flag("--map-list-error", f.map_list_error, help(Words::tr("Answer 500 for the list of maps")));
  command
      ->add_option("--grid-fault", f.grid_fault,
                   help(Words::tr("What is wrong with every map's place and resolution")))
      ->check(CLI::IsMember({"zero-resolution", "negative-resolution", "no-resolution", "no-origin"}))
      ->group(faults);
}

int run(int argc, char** argv) {
  CommandLine line;
  CLI::App cli(
      help(Words::tr(
          "mapwright: look at the maps of mobile robots. Without a subcommand it opens the window.")),
      "mapwright");
  cli.set_version_flag("--version", std::string("mapwright ") + MAPWRIGHT_VERSION);
  cli.set_help_all_flag("--help-all", help(Words::tr("Help on every subcommand")));
  cli.require_subcommand(0, 1);
  cli.add_option(
         "--robot", line.robot,
         help(Words::tr("Connect the window to this robot, for example axbot+http://192.168.25.25:8090")))
      ->envname("MAPWRIGHT_ROBOT");
  app::addAccess(cli, line.access);
  CLI::App* demo = cli.add_subcommand("demo", help(Words::tr("Open the window on a simulated robot")));
  demo->add_option("query", line.demo_query, help(Words::tr("Such as scene=warehouse&submaps=500&seed=3")));
  addSimulate(cli, line);
  addSnapshot(cli, line);
  app::addMaps(cli, line.maps);
  app::addWaypoints(cli, line.waypoints);
  CLI::App* bench = cli.add_subcommand(
      "bench", help(Words::tr("Measure against other ways to do the same, in the same run")));
  bench->prefix_command();
  bench->footer(help(
      Words::tr("Everything after bench goes to Google Benchmark, for example --benchmark_filter=Compose")));
  bench->set_help_flag();

  app::refuseOddWords(cli);
  try {
    cli.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return cli.exit(error);
    const QString why = QString::fromStdString(words::plainLine(std::string_view(error.what())));
    std::fprintf(stderr, "%s\n", qUtf8Printable(Words::tr("%1 (see mapwright --help)").arg(why)));
    return app::kUsage;
  }
  if (cli.got_subcommand("simulate")) return app::simulate(line.simulate);
  if (cli.got_subcommand("snapshot")) {
    if (line.snapshot.robot.empty()) line.snapshot.robot = line.robot;
    line.snapshot.access = app::withOuter(line.snapshot.access, line.snapshot.robot, line.access, line.robot);
    return app::snapshot(line.snapshot, argc, argv);
  }
  if (cli.got_subcommand("maps")) {
    if (line.maps.robot.empty()) line.maps.robot = line.robot;
    line.maps.access = app::withOuter(line.maps.access, line.maps.robot, line.access, line.robot);
    return app::runMaps(cli, line.maps, argc, argv);
  }
  if (cli.got_subcommand("waypoints")) {
    app::WaypointsWords& words = line.waypoints;
    if (words.robot.empty()) words.robot = line.robot;
    words.access = app::withOuter(words.access, words.robot, line.access, line.robot);
    return app::runWaypoints(cli, words, argc, argv);
  }
  if (cli.got_subcommand("bench")) return app::bench(bench->remaining());
  if (cli.got_subcommand("demo")) return app::demo(QString::fromStdString(line.demo_query), argc, argv);
  return app::window(QString::fromStdString(line.robot), line.access, argc, argv);
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
    std::fprintf(stderr, "%s\n", qUtf8Printable(Words::tr("mapwright had to stop: %1").arg(why)));
    return app::kRobotError;
  }
}
