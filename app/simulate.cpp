// mapwright simulate: the embedded robot on its own (docs/simulator.md).
#include <csignal>
#include <cstdio>
#include <map>
#include <memory>
#include <pthread.h>

#include <CLI/CLI.hpp>
#include <QCoreApplication>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/robot_access.h"
#include "simulator/simulator.h"
#include "words/listed.h"
#include "words/plain.h"

namespace mapwright::app {
namespace {

using simulator::FaultKind, simulator::RequestFault;

class SimulateOptions {
  Q_DECLARE_TR_FUNCTIONS(SimulateOptions)

 public:
  void addTo(CLI::App& command) {
    command_ = &command;
    addRobot();
    addFaults();
    addRosRobot(options_.ros);
    addRosFaults(options_.faults.ros);
    addDispatcher(options_.ros.dispatcher);
    addDispatcherFaults(options_.faults.ros.dispatcher);
  }
  /// Serves until SIGINT or SIGTERM; prints one JSON line with the addresses when ready. Returns an exit
  /// code.
  int run();

 private:
  void addRobot();
  void addFaults();
  void addRosRobot(simulator::RosOptions& o);
  void addRosFaults(simulator::RosFaults& f);
  void addDispatcher(simulator::DispatcherOptions& o);
  void addDispatcherFaults(simulator::DispatcherFaults& f);

  CLI::Option* grouped(CLI::Option* option) const {
    return group_.isEmpty() ? option : option->group(help(group_));
  }
  void flag(const char* name, bool& value, const QString& what) {
    grouped(command_->add_flag(name, value, help(what)));
  }
  template <typename Value>
  CLI::Option* option(const char* name, Value& value, const QString& what) {
    return grouped(command_->add_option(name, value, help(what)));
  }
  template <typename Value, typename Bound>
  CLI::Option* number(const char* name, Value& value, Bound low, Bound high, const QString& what) {
    return option(name, value, what)->check(CLI::Range(low, high));
  }
  void rate(const char* name, double& value, const QString& what) { number(name, value, 0.0, 1.0, what); }
  void names(const char* name, std::vector<std::string>& value, const QString& what) {
    option(name, value, what)->allow_extra_args(false);
  }
  /// Adds to the table of faults what `row` makes of the value.
  template <typename Value, typename Row>
  CLI::Option* fault(const char* name, const Row& row, const QString& what) {
    const auto add = [this, row](const Value& value) { options_.faults.requests.push_back(row(value)); };
    return grouped(command_->add_option_function<Value>(name, add, help(what)));
  }
  void share(const char* name, FaultKind kind, unsigned of, const QString& what) {
    const auto row = [this, kind, of](double rate) {
      return RequestFault{kind, of, rate, of == simulator::kSubmaps ? error_status_ : 0,
                          of == simulator::kWrites ? write_fault_path_ : std::string()};
    };
    fault<double>(name, row, what)->check(CLI::Range(0.0, 1.0));
  }
  void delay(const char* name, FaultKind kind, unsigned of, const QString& what) {
    fault<int>(
        name,
        [kind, of](int ms) {
          return RequestFault{kind, of, 1, ms};
        },
        what)
        ->check(CLI::Range(0, 600'000));
  }
  void paths(const char* name, FaultKind kind, const QString& what) {
    const auto add = [this, kind](const std::vector<std::string>& all) {
      for (const std::string& path : all)
        options_.faults.requests.push_back({kind, simulator::kAllRequests, 1, 0, path});
    };
    grouped(command_->add_option_function<std::vector<std::string>>(name, add, help(what)))
        ->allow_extra_args(false);
  }
  void faultFlag(const char* name, const RequestFault& row, const QString& what) {
    const auto add = [this, row] { options_.faults.requests.push_back(row); };
    grouped(command_->add_flag_callback(name, add, help(what)));
  }

  simulator::Options options_;
  std::string secret_file_, write_fault_path_;
  int error_status_ = 500;
  CLI::App* command_ = nullptr;
  QString group_;  // of the options that are being added
};

void SimulateOptions::addRobot() {
  simulator::Options& o = options_;
  const auto scenes = simulator::sceneNames();
  QStringList scene_names;
  for (const auto& [name, sentence] : scenes) scene_names << QString::fromStdString(name);
  option("--port", o.port, tr("Port of the Autoxing robot, 0 for any free port"))->capture_default_str();
  option("--aimdk-port", o.aimdk_port, tr("Port of the Agibot robot, 0 for any free port"))
      ->capture_default_str();
  flag("--aimdk-newer", o.aimdk.newer,
       tr("The Agibot robot has newer firmware: its maps and waypoints can be changed, and it can map"));
  flag("--aimdk-centimetres", o.aimdk.centimetres,
       tr("The resolution of the Agibot robot's maps means centimetres per pixel"));
  option("--scene", o.scene, tr("One of: %1").arg(words::listed(scene_names)))
      ->capture_default_str()
      ->check([scene_names](const std::string& given) {
        const QString scene = QString::fromStdString(given);
        return scene_names.contains(scene) ? std::string() : help(tr("there is no scene \"%1\"").arg(scene));
      });
  number("--submaps", o.submaps, 0, 100'000,
         tr("Approximate number of submaps (0 = as in the scene); beyond 20,000 they share 256 pictures"));
  option("--seed", o.seed, tr("Seed of everything random"))->capture_default_str();
  number("--speed", o.speed, 0.0, 1000.0, tr("Simulated seconds per real second"));
  number("--start-at", o.start_at_s, 0.0, 1e6, tr("Simulated time at the start, seconds"));
  flag("--paused", o.paused, tr("Stop the simulated clock"));
  option("--secret-file", secret_file_,
         tr("File with the secret without which the Autoxing robot answers 401"));
  flag("!--no-topic-lists", o.enable_topic_list, tr("Accept enable_topic for only one topic at a time"));
  flag("--odd-bags", o.bags.odd,
       tr("Add bags of eight hours, with a clock set back, with equal stamps, with a gap, with one message "
          "and "
          "with none; damaged ones, one that is not counted, and one of all that robots latch"));
  flag("--bag-end-exclusive", o.bags.end_exclusive, tr("A range request for a bag stops before end_time"));
  flag("!--no-download-ranges", o.bags.ranges, tr("Downloads cannot be resumed"));
  flag("!--no-binary", o.binary_topics, tr("Ignore ?pb=1"));
  flag("--positioning-asks", o.positioning_asks, tr("What global positioning finds has to be confirmed"));
  number("--points", o.points_per_scan, 0, 1'000'000, tr("Lidar points per scan"))->capture_default_str();
  number("--scan-hz", o.scan_hz, 0.1, 100.0, tr("Scans per second"))->capture_default_str();
  number("--pose-hz", o.pose_hz, 0.1, 100.0, tr("Poses per second"))->capture_default_str();
  number("--costmap-cells", o.costmap_cells, 20, 4000,
         tr("Edge length of the costmaps around the robot, in cells"))
      ->capture_default_str();
}

void SimulateOptions::addFaults() {
  using namespace simulator;
  Faults& f = options_.faults;
  group_ = tr("Faults");
  delay("--latency-ms", FaultKind::Delay, kSubmaps, tr("Delay of every submap response"));
  delay("--jitter-ms", FaultKind::Jitter, kSubmaps, tr("Random extra delay"));
  share("--drop-rate", FaultKind::Drop, kSubmaps, tr("Share of submap requests that get no response"));
  share("--truncate-rate", FaultKind::Truncate, kSubmaps, tr("Share of responses cut off half-way"));
  share("--wrong-size-rate", FaultKind::WrongSize, kSubmaps,
        tr("Share of responses whose width and height do not match the cells"));
  share("--corrupt-rate", FaultKind::Corrupt, kSubmaps, tr("Share of responses that are garbage"));
  option("--error-status", error_status_, tr("HTTP status of the responses of --error-rate"))
      ->check(CLI::IsMember({400, 404, 500, 502, 504}));
  share("--error-rate", FaultKind::Refuse, kSubmaps, tr("Share of responses with --error-status"));
  share("--status-code-rate", FaultKind::StatusError, kSubmaps,
        tr("Share of HTTP 200 responses that contain an error status"));
  number("--websocket-drop-every", f.websocket_drop_every_s, 0, 86'400,
         tr("Close the WebSocket every so many seconds"));
  number("--uuid-change-every", f.uuid_change_every_s, 0, 86'400, tr("Restart SLAM every so many seconds"));
  flag("--bad-entries", f.bad_entries,
       tr("List NaN poses, zero quaternions, duplicates and decreasing versions"));
  flag("--silent-websocket", f.silent_websocket, tr("Accept the WebSocket, then send nothing"));
  delay("--write-latency-ms", FaultKind::Delay, kWrites,
        tr("Delay of every response to a change: POST, PUT, PATCH, DELETE, and calls that change something"));
  option("--write-fault-path", write_fault_path_,
         tr("Only changes of this path or service, and of what is below it, go wrong, for example /maps/"));
  share("--write-error-rate", FaultKind::Refuse, kWrites,
        tr("Share of these that change nothing and get 500, 502 or 503"));
  share("--drop-writes", FaultKind::Drop, kWrites,
        tr("Share of these that change nothing and get no response"));
  share("--lose-write-answers", FaultKind::Cut, kWrites,
        tr("Share of these that take effect but get no response"));
  share("--ignore-writes", FaultKind::Ignore, kWrites,
        tr("Share of these that are answered as if all was well, but change nothing"));
  paths("--ros-refuse,--refuse", FaultKind::Refuse,
        tr("A path or service that answers with an error and does nothing; may be repeated"));
  paths("--ros-lose-answer,--lose-answer", FaultKind::Silence,
        tr("A path or service that does its work but never answers; may be repeated"));
  paths("--ros-cut-after,--cut-after", FaultKind::Cut,
        tr("A path or service that does its work, then closes the connection; may be repeated"));
  share("--cut-downloads", FaultKind::Truncate, kDownloads,
        tr("Share of .pbstream downloads that break off half-way"));
  names("--ros-silent,--silent", f.silent, tr("A topic that never publishes; may be repeated"));
  flag("--sees-nothing", f.sees_nothing,
       tr("The robot sees no charger, rack, pallet or trailer, and has collected no landmarks"));
  number("--overlay-edit-every", f.overlay_edit_every_s, 0, 86'400,
         tr("Someone else changes the overlays of the current map every so many seconds"));
  flag("--overlay-edit-before-writes", f.overlay_edit_before_writes,
       tr("Someone else changes the overlays right before each change of them"));
  delay("--map-latency-ms", FaultKind::Delay, kMaps, tr("Delay of every response about maps"));
  flag("--truncated-maps", f.truncated_maps, tr("Cut off every map's PNG half-way"));
  flag("--lying-map-size", f.lying_map_size, tr("Every map's PNG declares 60,000 x 60,000 pixels"));
  flag("--foreign-data-url", f.foreign_data_url, tr("data_url points to another host"));
  flag("--garbage-base64", f.garbage_base64, tr("Pictures in topics are not valid base64"));
  faultFlag("--map-list-error", {FaultKind::Refuse, kMapList, 1, 500}, tr("Answer 500 for the list of maps"));
  option("--grid-fault", f.grid_fault, tr("What is wrong with every map's place and resolution"))
      ->check(CLI::IsMember({"zero-resolution", "negative-resolution", "no-resolution", "no-origin"}));
}

void SimulateOptions::addRosRobot(simulator::RosOptions& o) {
  using simulator::RosDialect, simulator::RosWriter;
  group_.clear();
  option("--ros-port", o.port, tr("Port of the ROS robot, 0 for any free port"))->capture_default_str();
  option("--ros-dialect", o.dialect, tr("ros1 or ros2: type names, times and headers"))
      ->transform(CLI::CheckedTransformer(std::map<std::string, RosDialect>{{"ros1", RosDialect::Ros1},
                                                                            {"ros2", RosDialect::Ros2}})
                      .description("{ros1,ros2}"));
  option("--ros-writer", o.writer, tr("How to write JSON: escaped (\\/ and \\uXXXX), spaced or plain"))
      ->transform(CLI::CheckedTransformer(std::map<std::string, RosWriter>{{"escaped", RosWriter::Escaped},
                                                                           {"spaced", RosWriter::Spaced},
                                                                           {"plain", RosWriter::Plain}})
                      .description("{escaped,plain,spaced}"));
  flag("!--no-rosapi", o.rosapi, tr("The ROS robot has no /rosapi"));
  flag("!--no-kabam", o.kabam, tr("The ROS robot has no /map_manager"));
  flag("--ros-status", o.status, tr("Report errors in status messages"));
  flag("--ros-needs-auth", o.needs_auth,
       tr("Disconnect clients whose first message is not a complete auth message"));
  number("--waypoints", o.waypoints, 0, 100'000, tr("Number of waypoints in the ROS robot's current map"))
      ->capture_default_str();
  flag("--kabam-list-holds-archived", o.kabam_list_holds_archived, tr("map_list includes archived maps"));
  flag("--kabam-needs-flags", o.kabam_needs_flags,
       tr("Nothing is deleted unless delete_map or delete_waypoint is set"));
  flag("--kabam-empty-tags-keep", o.kabam_empty_tags_keep,
       tr("An update with an empty tag list leaves the tags unchanged"));
}

void SimulateOptions::addRosFaults(simulator::RosFaults& f) {
  group_ = tr("Faults of the ROS robot");
  using namespace simulator;
  delay("--ros-slow", FaultKind::Delay, kServices, tr("Delay of every service response, milliseconds"));
  flag("--ros-shuffle", f.shuffled_answers,
       tr("Every second response arrives after the ones that follow it"));
  flag("--ros-wrong-type", f.wrong_type, tr("/map, /scan and /odom have type std_msgs/String"));
  number("--ros-fragments", f.fragment_bytes, 0, 100'000'000,
         tr("Send messages in fragments of this many characters"));
  number("--ros-restart-every", f.restart_every_s, 0, 86'400,
         tr("Close all connections to the ROS robot every so many seconds"));
  flag("--ros-garbage", f.garbage, tr("Send frames that are not messages in between"));
  number("--other-operator", f.other_operator_every_s, 0, 86'400,
         tr("Another client changes waypoints and maps every so many seconds"));
  number("--waypoints-lag", f.waypoints_lag_ms, 0, 600'000,
         tr("The waypoint topic publishes changes this many milliseconds late"));
  number("--other-painter", f.other_painter_every_s, 0, 86'400,
         tr("Another client paints on the current map every so many seconds"));
  constexpr const char* kPicture = "/map_manager/update_map_image";
  fault<int>(
      "--ros-picture-code",
      [](int code) {
        return RequestFault{FaultKind::Refuse, kWrites, code > 0 ? 1.0 : 0.0, code, kPicture};
      },
      tr("update_map_image does nothing and returns this code"))
      ->check(CLI::Range(0, 255));
  faultFlag("--ros-picture-ignored", {FaultKind::Ignore, kWrites, 1, 0, kPicture},
            tr("update_map_image does nothing but reports success"));
  flag("--nan-pose", f.nan_pose, tr("Poses, transforms and some waypoints are NaN"));
  flag("--zero-quaternion", f.zero_quaternion, tr("Quaternions are zero or not normalized"));
  flag("--tf-loop", f.tf_loop, tr("/tf has a loop"));
  flag("--big-endian-cloud", f.big_endian_cloud, tr("/points is big-endian"));
}

void SimulateOptions::addDispatcher(simulator::DispatcherOptions& o) {
  group_ = tr("Map dispatcher (REP 130) of the ROS robot");
  flag("--dispatcher", o.there, tr("It exists, but nobody publishes the map as a topic"));
  number("--dispatcher-edge", o.edge_m, 10, 2000,
         tr("Edge length of its building in whole metres; 1000 gives "
            "20,000 x 20,000 cells and 40 million points"))
      ->type_name("INT")
      ->capture_default_str();
  flag("!--no-dispatcher-grid", o.planar, tr("Without get_map and get_sub_map"));
  flag("!--no-dispatcher-clouds", o.spatial, tr("Without clouds and projections"));
  flag("--dispatcher-writable", o.writable,
       tr("set_map_projections has type ProjectedMapsInfo, so projections can be set"));
  flag("--dispatcher-other-member", o.other_member,
       tr("It answers projected_maps instead of projected_maps_info"));
  flag("--dispatcher-map-msg", o.map_msg, tr("Its types come from map_msg"));
}

void SimulateOptions::addDispatcherFaults(simulator::DispatcherFaults& f) {
  option("--dispatcher-answer", f.answer,
         tr("What it returns for a region: pad, empty, rotated, elsewhere or corner"))
      ->check(CLI::IsMember({"pad", "empty", "rotated", "elsewhere", "corner"}));
  number("--dispatcher-most", f.most_cells, 0, 40'000'000,
         tr("Maximum number of cells in the grid of a region, 0 for no limit"));
  option("--dispatcher-too-much", f.too_much,
         tr("What it returns for a larger region: cut (the lower left part), empty or error"))
      ->check(CLI::IsMember({"cut", "empty", "error"}));
  option("--dispatcher-lie", f.cloud.lie,
         tr("What is wrong with its clouds: point-step, row-step, width "
            "or data; with its grids: data or cells"))
      ->check(CLI::IsMember({"point-step", "row-step", "width", "data", "cells"}));
  flag("--dispatcher-big-endian", f.cloud.big_endian, tr("Its clouds are big-endian"));
  flag("--dispatcher-float64", f.cloud.float64, tr("Its clouds have 64-bit coordinates"));
  flag("--dispatcher-odd-offsets", f.cloud.odd_offsets, tr("The fields of its clouds are not aligned"));
  flag("--dispatcher-no-z", f.cloud.no_z, tr("Its clouds have no z"));
  flag("--dispatcher-nan", f.cloud.nan, tr("Every tenth point of its clouds is NaN"));
  number("--dispatcher-far", f.cloud.far_m, -1e8, 1e8, tr("Shift x and y of its clouds by this many metres"));
  flag("--dispatcher-resolution-changes", f.resolution_changes,
       tr("The resolution of its grids changes from call to call"));
  flag("--dispatcher-regrids", f.regrids, tr("The layout of its grid changes every fourth call"));
}

int SimulateOptions::run() {
  // MAPWRIGHT_SECRET is for clients: only a file makes this robot require a secret.
  if (!secret_file_.empty()) {
    const QString file = QString::fromStdString(secret_file_);
    const auto secret = readSecret(file);
    if (!secret || secret->isEmpty()) {
      const QString why = secret ? tr("The secret file %1 holds no secret.").arg(file) : secret.error();
      std::fprintf(stderr, "%s\n", qUtf8Printable(why));
      return kUsage;
    }
    options_.secret = secret->toStdString();
  }
  // Blocked before any thread starts, so that they only arrive at sigwait().
  sigset_t stop_signals;
  sigemptyset(&stop_signals);
  sigaddset(&stop_signals, SIGINT);
  sigaddset(&stop_signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &stop_signals, nullptr);

  simulator::Simulator robot(options_);
  if (const auto error = robot.start()) {
    std::fprintf(stderr, "%s\n", words::plainLine(*error).c_str());
    return kUnreachable;
  }
  const std::string rep130 =
      options_.ros.dispatcher.there ? R"(,"rep130":")" + robot.rep130Address() + '"' : std::string();
  std::printf(R"({"axbot":"%s","aimdk":"%s","ros":"%s","kabam":"%s"%s})"
              "\n",
              robot.address().c_str(), robot.aimdkAddress().c_str(), robot.rosAddress().c_str(),
              robot.kabamAddress().c_str(), rep130.c_str());
  std::fflush(stdout);
  int received = 0;
  sigwait(&stop_signals, &received);
  robot.stop();
  return kDone;
}

}  // namespace

void addSimulate(Commands& commands) {
  const auto options = std::make_shared<SimulateOptions>();
  CLI::App* command = commands.program().add_subcommand(
      "simulate", help(SimulateOptions::tr("Run a simulated robot on 127.0.0.1")));
  options->addTo(*command);
  commands.add(command, [options](const Invocation&) { return options->run(); });
}

}  // namespace mapwright::app
