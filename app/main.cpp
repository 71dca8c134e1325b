// mapwright: one binary for the window and its headless twin (cli.md).
#include <csignal>
#include <cstdio>
#include <exception>
#include <string>

#include <CLI/CLI.hpp>

#include "app/bench/bench.h"
#include "app/exit_code.h"
#include "app/maps.h"
#include "app/option_words.h"
#include "app/output_paths.h"
#include "app/simulate.h"
#include "app/snapshot.h"
#include "app/window.h"
#include "app/xdg.h"
#include "scene/layer.h"
#include "words/plain.h"

namespace {

using namespace mapwright;

struct CommandLine {
  std::string robot, demo_query;
  app::AccessWords access;
  app::SnapshotWords snapshot;
  app::MapsWords maps;
  app::SimulateWords simulate;
  std::vector<std::string> bench_arguments;
};

std::string layersHelp() {
  QStringList names;
  for (const scene::Layer layer : scene::allLayers()) names << scene::layerName(layer);
  return "Comma-separated: " + names.join(QLatin1Char(',')).toStdString() +
         "; or all; or none (the map alone)";
}

void addAccess(CLI::App& command, app::AccessWords& words) {
  command.add_option("--secret-file", words.secret_file,
                     "File that holds the secret of the robot of --robot (or MAPWRIGHT_SECRET)");
  command
      .add_option("--secret-file-for", words.secret_files_for,
                  "Address of another robot, and the file that holds its secret; may be repeated")
      ->type_name("ADDRESS FILE")
      ->allow_extra_args(false);
  command.add_option("--ca-file", words.ca_file,
                     "PEM file of certificate authorities (or self-signed certificates) to believe besides "
                     "those of this computer");
}

void addSnapshot(CLI::App& cli, CommandLine& line) {
  CLI::App* command = cli.add_subcommand("snapshot", "Draw a robot's map into a PNG, without a window");
  app::SnapshotWords& words = line.snapshot;
  command
      ->add_option("--robot", words.robot,
                   "Robot address, for example axbot+http://192.168.25.25:8090 or demo:")
      ->envname("MAPWRIGHT_ROBOT");
  addAccess(*command, words.access);
  command->add_option("-o,--output", words.output, "The PNG to write; - is the standard output")->required();
  command->add_flag("--force", words.force, "Write even over a file that the map is read from");
  command->add_option("--mode", words.mode,
                      "submaps, or whole (grid: the same for robots and files that give "
                      "their occupancy grid as a whole map). Without it: submaps where there are some");
  command->add_option(
      "--map", words.map,
      "A stored map by its id, or mapping:ID (see mapwright maps list); without it the live or current "
      "one");
  command->add_flag("--average", words.average,
                    "Zoomed out, whole maps show the average instead of letting the occupied win");
  command->add_flag("--robot-anyway", words.robot_anyway,
                    "Draw the robot, and what it sees, also on a map that it is not in");
  command->add_flag("--fit", words.fit, "Show everything (the default without --center)");
  command->add_option("--center", words.center, "World point in the middle: X,Y in metres");
  command->add_option("--scale", words.scale, "Metres per pixel");
  command->add_option("--size", words.size, "Picture size: WIDTHxHEIGHT in pixels")->capture_default_str();
  command->add_option("--rotate", words.rotate_deg,
                      "Turn the picture counter-clockwise by this many degrees");
  command->add_option("--layers", words.layers, layersHelp());
  command->add_option("--resolution", words.resolution, "Metres per pixel of a bare picture file");
  command->add_option("--origin", words.origin,
                      "Lower left corner of a bare picture file: X,Y or X,Y,YAW in metres and radians");
  command->add_option("--slice", words.slice, "Which slice of each submap")->capture_default_str();
  command->add_option("--colors", words.colors, "normal, incremental or active")->capture_default_str();
  command->add_option("--theme", words.theme, "light or dark")->capture_default_str();
  command->add_flag("--raw", words.raw, "Only the map raster: gray = intensity, alpha 0 = not observed");
  command->add_option("--settle", words.settle, "complete, or how many seconds to collect")
      ->capture_default_str();
  command->add_option("--timeout", words.timeout_s, "Give up waiting after this many seconds")
      ->capture_default_str();
  command->add_option("--report", words.report, "Write what was done as JSON; - is the standard output");
  command->add_flag("--json", words.json, "Print the report on standard output");
}

void addMaps(CLI::App& cli, CommandLine& line) {
  CLI::App* maps =
      cli.add_subcommand("maps", "The maps that a robot or a folder keeps: list, export, compare");
  maps->require_subcommand(1);
  app::MapsWords& words = line.maps;
  const auto add = [&](const char* name, const char* what) {
    CLI::App* command = maps->add_subcommand(name, what);
    // No envname(): the subcommands share the word, and the variable would be read for those that were not
    // given, over what was typed. It comes from the option before the subcommand.
    command->add_option("--robot", words.robot,
                        "Robot address, map.yaml, picture or folder (or MAPWRIGHT_ROBOT)");
    addAccess(*command, words.access);
    command->add_option("--timeout", words.timeout_s, "Give up waiting after this many seconds")
        ->capture_default_str();
    command->add_option(
        "--resolution", words.resolution,
        "Metres per cell: of a bare picture file, or of submaps that are exported or compared (0.05)");
    command->add_option("--origin", words.origin, "Lower left corner of a bare picture file: X,Y or X,Y,YAW");
    command->add_option("--report", words.report, "Write what was done, and every warning, as JSON");
    return command;
  };
  const char* which =
      "A stored map by its id, mapping:ID, live, or submaps; without it the live or current one";
  for (const auto& [name, what] : {std::pair{"list", "All maps and mapping results; * marks the current one"},
                                   std::pair{"current", "The map that the robot works with"}}) {
    add(name, what)->add_flag("--json", words.json, "Machine-readable");
  }
  CLI::App* show = add("show", "Size, place, dates and navigation points of one map");
  show->add_option("id", words.id, which);
  show->add_flag("--json", words.json, "Machine-readable");
  CLI::App* exported = add("export", "Write a map as PNG, or as PGM and YAML for map_server");
  exported->add_option("id", words.id, which);
  exported
      ->add_option(
          "-o,--output", words.output,
          "What to write: NAME.png, or NAME.yaml / NAME.pgm (both); - is a PNG on the standard output")
      ->required();
  exported->add_flag("--force", words.force, "Write even over a file that the map is read from");
  exported->add_option("--format", words.format, "png or pgm, when the name does not tell");
  exported->add_flag("--world-file", words.world_file, "Write NAME.pgw (world file) beside it");
  CLI::App* diff = add("diff", "Compare two maps cell by cell; exit code 1 when they differ");
  diff->add_option("first", words.first,
                   "A map of --robot (id, mapping:ID, live, submaps), or a file or address")
      ->required();
  diff->add_option("second", words.second, "Likewise")->required();
  diff->add_option("--diff", words.diff_picture, "Write the difference as a PNG; - is the standard output");
  diff->add_flag("--force", words.force, "Write even over a file that a map is read from");
  diff->add_flag("--json", words.json, "Machine-readable");
}

void addSimulate(CLI::App& cli, CommandLine& line) {
  std::string scenes;
  for (const auto& [name, sentence] : simulator::sceneNames()) scenes += (scenes.empty() ? "" : ", ") + name;
  CLI::App* command = cli.add_subcommand("simulate", "Serve a simulated robot on 127.0.0.1");
  simulator::Options& o = line.simulate.options;
  command->add_option("--port", o.port, "Port of the Autoxing robot, 0 = a free one")->capture_default_str();
  command->add_option("--aimdk-port", o.aimdk_port, "Port of the Agibot robot, 0 = a free one")
      ->capture_default_str();
  command->add_option("--scene", o.scene, "One of: " + scenes)
      ->capture_default_str()
      ->check([](const std::string& s) {
        for (const auto& [name, sentence] : simulator::sceneNames()) {
          if (name == s) return std::string();
        }
        return "there is no scene \"" + s + "\"";
      });
  command->add_option("--submaps", o.submaps, "About how many submaps (0 = as the scene has)")
      ->check(CLI::Range(0, 100'000));
  command->add_option("--seed", o.seed, "Everything random follows from this")->capture_default_str();
  command->add_option("--speed", o.speed, "Simulated seconds per second")->check(CLI::Range(0.0, 1000.0));
  command->add_option("--start-at", o.start_at_s, "Simulated time at start, seconds")
      ->check(CLI::Range(0.0, 1e6));
  command->add_flag("--paused", o.paused, "Let simulated time stand still");
  command->add_option("--secret-file", line.simulate.secret_file,
                      "File that holds the secret without which the Autoxing robot answers 401");
  command->add_flag("!--no-topic-lists", o.enable_topic_list, "Understand enable_topic one by one only");
  command->add_flag("!--no-binary", o.binary_topics, "Ignore ?pb=1");
  command->add_option("--points", o.points_per_scan, "Lidar points in a scan")
      ->check(CLI::Range(0, 1'000'000))
      ->capture_default_str();
  command->add_option("--scan-hz", o.scan_hz, "Scans per second")
      ->check(CLI::Range(0.1, 100.0))
      ->capture_default_str();
  command->add_option("--pose-hz", o.pose_hz, "Poses per second")
      ->check(CLI::Range(0.1, 100.0))
      ->capture_default_str();
  command->add_option("--costmap-cells", o.costmap_cells, "Edge of the costmaps around the robot, cells")
      ->check(CLI::Range(20, 4000))
      ->capture_default_str();
  simulator::Faults& f = o.faults;
  const auto rate = [&](const char* name, double& value, const char* what) {
    command->add_option(name, value, what)->check(CLI::Range(0.0, 1.0))->group("Faults");
  };
  const auto count = [&](const char* name, int& value, const char* what, int limit) {
    command->add_option(name, value, what)->check(CLI::Range(0, limit))->group("Faults");
  };
  count("--latency-ms", f.latency_ms, "Delay of every submap answer", 600'000);
  count("--jitter-ms", f.jitter_ms, "Random addition to the delay", 600'000);
  rate("--drop-rate", f.drop_rate, "Share of submap requests dropped without an answer");
  rate("--truncate-rate", f.truncate_rate, "Share of answers cut off half-way");
  rate("--wrong-size-rate", f.wrong_size_rate,
       "Share of answers whose width and height do not fit the cells");
  rate("--corrupt-rate", f.corrupt_rate, "Share of answers that are garbage");
  rate("--error-rate", f.error_rate, "Share of answers with --error-status");
  command->add_option("--error-status", f.error_status, "HTTP status of those errors")
      ->check(CLI::IsMember({400, 404, 500, 502, 504}))
      ->group("Faults");
  rate("--status-code-rate", f.status_code_rate, "Share of HTTP 200 answers whose own status is an error");
  count("--websocket-drop-every", f.websocket_drop_every_s, "Cut the WebSocket every so many seconds",
        86'400);
  count("--uuid-change-every", f.uuid_change_every_s, "Restart SLAM every so many seconds", 86'400);
  command
      ->add_flag("--bad-entries", f.bad_entries,
                 "List NaN poses, zero quaternions, duplicates, versions going back")
      ->group("Faults");
  command->add_flag("--silent-websocket", f.silent_websocket, "Accept the WebSocket, then say nothing")
      ->group("Faults");
  count("--write-latency-ms", f.write_latency_ms, "Delay of every answer to POST, PUT, PATCH and DELETE",
        600'000);
  rate("--write-error-rate", f.write_error_rate,
       "Share of those that change nothing and get 500, 502 or 503");
  rate("--drop-writes", f.drop_writes, "Share of those that change nothing and get no answer");
  rate("--lose-write-answers", f.lose_write_answers, "Share of those that are carried out but get no answer");
  count("--map-latency-ms", f.map_latency_ms, "Delay of every answer about maps", 600'000);
  const auto flag = [&](const char* name, bool& value, const char* what) {
    command->add_flag(name, value, what)->group("Faults");
  };
  flag("--truncated-maps", f.truncated_maps, "Cut every map's PNG in half");
  flag("--lying-map-size", f.lying_map_size, "Every map's PNG declares 60,000 x 60,000 pixels");
  flag("--foreign-data-url", f.foreign_data_url, "data_url points to another host");
  flag("--garbage-base64", f.garbage_base64, "Pictures in topics are no base64");
  flag("--map-list-error", f.map_list_error, "Answer 500 for the list of maps");
  command->add_option("--grid-fault", f.grid_fault, "What is wrong with every map's place and resolution")
      ->check(CLI::IsMember({"zero-resolution", "negative-resolution", "no-resolution", "no-origin"}))
      ->group("Faults");
}

int run(int argc, char** argv) {
  CommandLine line;
  CLI::App cli("mapwright: look at the maps of mobile robots. Without a subcommand it opens the window.",
               "mapwright");
  cli.set_version_flag("--version", std::string("mapwright ") + MAPWRIGHT_VERSION);
  cli.set_help_all_flag("--help-all", "Help on every subcommand");
  cli.require_subcommand(0, 1);
  cli.add_option("--robot", line.robot,
                 "Connect the window to this robot, for example axbot+http://192.168.25.25:8090")
      ->envname("MAPWRIGHT_ROBOT");
  addAccess(cli, line.access);
  CLI::App* demo = cli.add_subcommand("demo", "Open the window on a simulated robot");
  demo->add_option("query", line.demo_query, "Such as scene=warehouse&submaps=500&seed=3");
  addSimulate(cli, line);
  addSnapshot(cli, line);
  addMaps(cli, line);
  CLI::App* bench = cli.add_subcommand("bench", "Measure against other ways to do the same, in the same run");
  bench->prefix_command();
  bench->footer("Everything after bench goes to Google Benchmark, for example --benchmark_filter=Compose");
  bench->set_help_flag();

  app::refuseOddWords(cli);
  try {
    cli.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return cli.exit(error);
    std::fprintf(stderr, "%s (see mapwright --help)\n",
                 words::plainLine(std::string_view(error.what())).c_str());
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
    const CLI::App* maps = cli.get_subcommand("maps");
    if (maps->got_subcommand("list")) return app::mapsList(line.maps, argc, argv);
    if (maps->got_subcommand("current")) return app::mapsCurrent(line.maps, argc, argv);
    if (maps->got_subcommand("show")) return app::mapsShow(line.maps, argc, argv);
    if (maps->got_subcommand("export")) return app::mapsExport(line.maps, argc, argv);
    return app::mapsDiff(line.maps, argc, argv);
  }
  if (cli.got_subcommand("bench")) return app::bench(bench->remaining(), argv[0]);
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
    std::fprintf(stderr, "mapwright had to stop: %s\n",
                 words::plainLine(std::string_view(error.what())).c_str());
    return app::kRobotError;
  }
}
