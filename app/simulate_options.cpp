#include <map>
#include <memory>

#include <CLI/CLI.hpp>
#include <QCoreApplication>

#include "app/commands.h"
#include "app/simulate.h"
#include "simulator/simulator.h"

namespace mapwright::app {
namespace {

class SimulateOptionsText {
  Q_DECLARE_TR_FUNCTIONS(SimulateOptions)
};

void addRosRobot(CLI::App& command, simulator::RosOptions& o) {
  command
      .add_option("--ros-port", o.port,
                  help(SimulateOptionsText::tr("Port of the ROS robot, 0 for any free port")))
      ->capture_default_str();
  command
      .add_option("--ros-dialect", o.dialect,
                  help(SimulateOptionsText::tr("ros1 or ros2: type names, times and headers")))
      ->transform(CLI::CheckedTransformer(std::map<std::string, simulator::RosDialect>{
          {"ros1", simulator::RosDialect::Ros1}, {"ros2", simulator::RosDialect::Ros2}}));
  command
      .add_option(
          "--ros-writer", o.writer,
          help(SimulateOptionsText::tr("How to write JSON: escaped (\\/ and \\uXXXX), spaced or plain")))
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, simulator::RosWriter>{{"escaped", simulator::RosWriter::Escaped},
                                                      {"spaced", simulator::RosWriter::Spaced},
                                                      {"plain", simulator::RosWriter::Plain}}));
  command.add_flag("!--no-rosapi", o.rosapi, help(SimulateOptionsText::tr("The ROS robot has no /rosapi")));
  command.add_flag("!--no-kabam", o.kabam,
                   help(SimulateOptionsText::tr("The ROS robot has no /map_manager")));
  command.add_flag("--ros-status", o.status,
                   help(SimulateOptionsText::tr("Report errors in status messages")));
  command.add_flag(
      "--ros-needs-auth", o.needs_auth,
      help(SimulateOptionsText::tr("Disconnect clients whose first message is not a complete auth message")));
  command
      .add_option("--waypoints", o.waypoints,
                  help(SimulateOptionsText::tr("Number of waypoints in the ROS robot's current map")))
      ->check(CLI::Range(0, 100'000))
      ->capture_default_str();
  command.add_flag("--kabam-list-holds-archived", o.kabam_list_holds_archived,
                   help(SimulateOptionsText::tr("map_list includes archived maps")));
  command.add_flag(
      "--kabam-needs-flags", o.kabam_needs_flags,
      help(SimulateOptionsText::tr("Nothing is deleted unless delete_map or delete_waypoint is set")));
  command.add_flag(
      "--kabam-empty-tags-keep", o.kabam_empty_tags_keep,
      help(SimulateOptionsText::tr("An update with an empty tag list leaves the tags unchanged")));
}

void addDispatcher(CLI::App& command, simulator::DispatcherOptions& o) {
  const std::string group = help(SimulateOptionsText::tr("Map dispatcher (REP 130) of the ROS robot"));
  command
      .add_flag("--dispatcher", o.there,
                help(SimulateOptionsText::tr("It exists, but nobody publishes the map as a topic")))
      ->group(group);
  command
      .add_option("--dispatcher-edge", o.edge_m,
                  help(SimulateOptionsText::tr("Edge length of its building in whole metres; 1000 gives "
                                               "20,000 x 20,000 cells and 40 million points")))
      ->check(CLI::Range(10, 2000))
      ->capture_default_str()
      ->group(group);
  command
      .add_flag("!--no-dispatcher-grid", o.planar,
                help(SimulateOptionsText::tr("Without get_map and get_sub_map")))
      ->group(group);
  command
      .add_flag("!--no-dispatcher-clouds", o.spatial,
                help(SimulateOptionsText::tr("Without clouds and projections")))
      ->group(group);
  command
      .add_flag("--dispatcher-writable", o.writable,
                help(SimulateOptionsText::tr(
                    "set_map_projections has type ProjectedMapsInfo, so projections can be set")))
      ->group(group);
  command
      .add_flag("--dispatcher-other-member", o.other_member,
                help(SimulateOptionsText::tr("It answers projected_maps instead of projected_maps_info")))
      ->group(group);
  command
      .add_flag("--dispatcher-map-msg", o.map_msg,
                help(SimulateOptionsText::tr("Its types come from map_msg")))
      ->group(group);
}

void addDispatcherFaults(CLI::App& command, simulator::DispatcherFaults& f) {
  const std::string group = help(SimulateOptionsText::tr("Map dispatcher (REP 130) of the ROS robot"));
  const auto flag = [&](const char* name, bool& value, const std::string& what) {
    command.add_flag(name, value, what)->group(group);
  };
  command
      .add_option("--dispatcher-answer", f.answer,
                  help(SimulateOptionsText::tr(
                      "What it returns for a region: pad, empty, rotated, elsewhere or corner")))
      ->check(CLI::IsMember({"pad", "empty", "rotated", "elsewhere", "corner"}))
      ->group(group);
  command
      .add_option(
          "--dispatcher-most", f.most_cells,
          help(SimulateOptionsText::tr("Maximum number of cells in the grid of a region, 0 for no limit")))
      ->check(CLI::Range(0, 40'000'000))
      ->group(group);
  command
      .add_option("--dispatcher-too-much", f.too_much,
                  help(SimulateOptionsText::tr(
                      "What it returns for a larger region: cut (the lower left part), empty or error")))
      ->check(CLI::IsMember({"cut", "empty", "error"}))
      ->group(group);
  command
      .add_option("--dispatcher-lie", f.cloud.lie,
                  help(SimulateOptionsText::tr("What is wrong with its clouds: point-step, row-step, width "
                                               "or data; with its grids: data or cells")))
      ->check(CLI::IsMember({"point-step", "row-step", "width", "data", "cells"}))
      ->group(group);
  flag("--dispatcher-big-endian", f.cloud.big_endian,
       help(SimulateOptionsText::tr("Its clouds are big-endian")));
  flag("--dispatcher-float64", f.cloud.float64,
       help(SimulateOptionsText::tr("Its clouds have 64-bit coordinates")));
  flag("--dispatcher-odd-offsets", f.cloud.odd_offsets,
       help(SimulateOptionsText::tr("The fields of its clouds are not aligned")));
  flag("--dispatcher-no-z", f.cloud.no_z, help(SimulateOptionsText::tr("Its clouds have no z")));
  flag("--dispatcher-nan", f.cloud.nan,
       help(SimulateOptionsText::tr("Every tenth point of its clouds is NaN")));
  command
      .add_option("--dispatcher-far", f.cloud.far_m,
                  help(SimulateOptionsText::tr("Shift x and y of its clouds by this many metres")))
      ->check(CLI::Range(-1e8, 1e8))
      ->group(group);
  flag("--dispatcher-resolution-changes", f.resolution_changes,
       help(SimulateOptionsText::tr("The resolution of its grids changes from call to call")));
  flag("--dispatcher-regrids", f.regrids,
       help(SimulateOptionsText::tr("The layout of its grid changes every fourth call")));
}

void addRosFaults(CLI::App& command, simulator::RosFaults& f) {
  const std::string faults = help(SimulateOptionsText::tr("Faults of the ROS robot"));
  const auto count = [&](const char* name, int& value, const std::string& what, int limit) {
    command.add_option(name, value, what)->check(CLI::Range(0, limit))->group(faults);
  };
  const auto flag = [&](const char* name, bool& value, const std::string& what) {
    command.add_flag(name, value, what)->group(faults);
  };
  const auto names = [&](const char* name, std::vector<std::string>& value, const std::string& what) {
    command.add_option(name, value, what)->allow_extra_args(false)->group(faults);
  };
  count("--ros-slow", f.slow_ms,
        help(SimulateOptionsText::tr("Delay of every service response, milliseconds")), 600'000);
  flag("--ros-shuffle", f.shuffled_answers,
       help(SimulateOptionsText::tr("Every second response arrives after the ones that follow it")));
  names("--ros-silent", f.silent,
        help(SimulateOptionsText::tr("A topic that never publishes; may be repeated")));
  flag("--ros-wrong-type", f.wrong_type,
       help(SimulateOptionsText::tr("/map, /scan and /odom have type std_msgs/String")));
  count("--ros-fragments", f.fragment_bytes,
        help(SimulateOptionsText::tr("Send messages in fragments of this many characters")), 100'000'000);
  count("--ros-restart-every", f.restart_every_s,
        help(SimulateOptionsText::tr("Close all connections to the ROS robot every so many seconds")),
        86'400);
  names("--ros-refuse", f.refuse,
        help(SimulateOptionsText::tr(
            "A service that responds result:false and does nothing; may be repeated")));
  names("--ros-lose-answer", f.lose_answer,
        help(SimulateOptionsText::tr("A service that does its work but never responds; may be repeated")));
  names("--ros-cut-after", f.cut_after,
        help(SimulateOptionsText::tr(
            "A service that does its work, then closes the connection; may be repeated")));
  flag("--ros-garbage", f.garbage,
       help(SimulateOptionsText::tr("Send frames that are not messages in between")));
  count("--other-operator", f.other_operator_every_s,
        help(SimulateOptionsText::tr("Another client changes waypoints and maps every so many seconds")),
        86'400);
  count("--waypoints-lag", f.waypoints_lag_ms,
        help(SimulateOptionsText::tr("The waypoint topic publishes changes this many milliseconds late")),
        600'000);
  count("--other-painter", f.other_painter_every_s,
        help(SimulateOptionsText::tr("Another client paints on the current map every so many seconds")),
        86'400);
  count("--ros-picture-code", f.picture_code,
        help(SimulateOptionsText::tr("update_map_image does nothing and returns this code")), 255);
  flag("--ros-picture-ignored", f.picture_ignored,
       help(SimulateOptionsText::tr("update_map_image does nothing but reports success")));
  flag("--nan-pose", f.nan_pose,
       help(SimulateOptionsText::tr("Poses, transforms and some waypoints are NaN")));
  flag("--zero-quaternion", f.zero_quaternion,
       help(SimulateOptionsText::tr("Quaternions are zero or not normalized")));
  flag("--tf-loop", f.tf_loop, help(SimulateOptionsText::tr("/tf has a loop")));
  flag("--big-endian-cloud", f.big_endian_cloud, help(SimulateOptionsText::tr("/points is big-endian")));
}

}  // namespace

void addSimulate(Commands& commands) {
  const auto words = std::make_shared<SimulateWords>();
  std::string scenes;
  for (const auto& [name, sentence] : simulator::sceneNames()) scenes += (scenes.empty() ? "" : ", ") + name;
  CLI::App* command = commands.program().add_subcommand(
      "simulate", help(SimulateOptionsText::tr("Run a simulated robot on 127.0.0.1")));
  simulator::Options& o = words->options;
  command
      ->add_option("--port", o.port,
                   help(SimulateOptionsText::tr("Port of the Autoxing robot, 0 for any free port")))
      ->capture_default_str();
  command
      ->add_option("--aimdk-port", o.aimdk_port,
                   help(SimulateOptionsText::tr("Port of the Agibot robot, 0 for any free port")))
      ->capture_default_str();
  command
      ->add_option("--scene", o.scene,
                   help(SimulateOptionsText::tr("One of: %1").arg(QString::fromStdString(scenes))))
      ->capture_default_str()
      ->check([](const std::string& s) {
        for (const auto& [name, sentence] : simulator::sceneNames()) {
          if (name == s) return std::string();
        }
        return help(SimulateOptionsText::tr("there is no scene \"%1\"").arg(QString::fromStdString(s)));
      });
  command
      ->add_option(
          "--submaps", o.submaps,
          help(SimulateOptionsText::tr(
              "Approximate number of submaps (0 = as in the scene); beyond 20,000 they share 256 pictures")))
      ->check(CLI::Range(0, 100'000));
  command->add_option("--seed", o.seed, help(SimulateOptionsText::tr("Seed of everything random")))
      ->capture_default_str();
  command->add_option("--speed", o.speed, help(SimulateOptionsText::tr("Simulated seconds per real second")))
      ->check(CLI::Range(0.0, 1000.0));
  command
      ->add_option("--start-at", o.start_at_s,
                   help(SimulateOptionsText::tr("Simulated time at the start, seconds")))
      ->check(CLI::Range(0.0, 1e6));
  command->add_flag("--paused", o.paused, help(SimulateOptionsText::tr("Stop the simulated clock")));
  command->add_option(
      "--secret-file", words->secret_file,
      help(SimulateOptionsText::tr("File with the secret without which the Autoxing robot answers 401")));
  command->add_flag("!--no-topic-lists", o.enable_topic_list,
                    help(SimulateOptionsText::tr("Accept enable_topic for only one topic at a time")));
  command->add_flag("--odd-bags", o.bags.odd,
                    help(SimulateOptionsText::tr("Add bags of eight hours, with a clock set back, with equal "
                                                 "stamps, with a gap, with one message and with none")));
  command->add_flag("--bag-end-exclusive", o.bags.end_exclusive,
                    help(SimulateOptionsText::tr("A range request for a bag stops before end_time")));
  command->add_flag("!--no-download-ranges", o.bags.ranges,
                    help(SimulateOptionsText::tr("Downloads cannot be resumed")));
  command->add_flag("!--no-binary", o.binary_topics, help(SimulateOptionsText::tr("Ignore ?pb=1")));
  command->add_option("--points", o.points_per_scan, help(SimulateOptionsText::tr("Lidar points per scan")))
      ->check(CLI::Range(0, 1'000'000))
      ->capture_default_str();
  command->add_option("--scan-hz", o.scan_hz, help(SimulateOptionsText::tr("Scans per second")))
      ->check(CLI::Range(0.1, 100.0))
      ->capture_default_str();
  command->add_option("--pose-hz", o.pose_hz, help(SimulateOptionsText::tr("Poses per second")))
      ->check(CLI::Range(0.1, 100.0))
      ->capture_default_str();
  command
      ->add_option("--costmap-cells", o.costmap_cells,
                   help(SimulateOptionsText::tr("Edge length of the costmaps around the robot, in cells")))
      ->check(CLI::Range(20, 4000))
      ->capture_default_str();
  simulator::Faults& f = o.faults;
  const std::string faults = help(SimulateOptionsText::tr("Faults"));
  const auto rate = [&](const char* name, double& value, const std::string& what) {
    command->add_option(name, value, what)->check(CLI::Range(0.0, 1.0))->group(faults);
  };
  const auto count = [&](const char* name, int& value, const std::string& what, int limit) {
    command->add_option(name, value, what)->check(CLI::Range(0, limit))->group(faults);
  };
  count("--latency-ms", f.latency_ms, help(SimulateOptionsText::tr("Delay of every submap response")),
        600'000);
  count("--jitter-ms", f.jitter_ms, help(SimulateOptionsText::tr("Random extra delay")), 600'000);
  rate("--drop-rate", f.drop_rate,
       help(SimulateOptionsText::tr("Share of submap requests that get no response")));
  rate("--truncate-rate", f.truncate_rate,
       help(SimulateOptionsText::tr("Share of responses cut off half-way")));
  rate("--wrong-size-rate", f.wrong_size_rate,
       help(SimulateOptionsText::tr("Share of responses whose width and height do not match the cells")));
  rate("--corrupt-rate", f.corrupt_rate,
       help(SimulateOptionsText::tr("Share of responses that are garbage")));
  rate("--error-rate", f.error_rate, help(SimulateOptionsText::tr("Share of responses with --error-status")));
  command
      ->add_option("--error-status", f.error_status,
                   help(SimulateOptionsText::tr("HTTP status of these errors")))
      ->check(CLI::IsMember({400, 404, 500, 502, 504}))
      ->group(faults);
  rate("--status-code-rate", f.status_code_rate,
       help(SimulateOptionsText::tr("Share of HTTP 200 responses that contain an error status")));
  count("--websocket-drop-every", f.websocket_drop_every_s,
        help(SimulateOptionsText::tr("Close the WebSocket every so many seconds")), 86'400);
  count("--uuid-change-every", f.uuid_change_every_s,
        help(SimulateOptionsText::tr("Restart SLAM every so many seconds")), 86'400);
  command
      ->add_flag("--bad-entries", f.bad_entries,
                 help(SimulateOptionsText::tr(
                     "List NaN poses, zero quaternions, duplicates and decreasing versions")))
      ->group(faults);
  command
      ->add_flag("--silent-websocket", f.silent_websocket,
                 help(SimulateOptionsText::tr("Accept the WebSocket, then send nothing")))
      ->group(faults);
  count("--write-latency-ms", f.write_latency_ms,
        help(SimulateOptionsText::tr("Delay of every response to POST, PUT, PATCH and DELETE")), 600'000);
  rate("--write-error-rate", f.write_error_rate,
       help(SimulateOptionsText::tr("Share of these that change nothing and get 500, 502 or 503")));
  rate("--drop-writes", f.drop_writes,
       help(SimulateOptionsText::tr("Share of these that change nothing and get no response")));
  rate("--lose-write-answers", f.lose_write_answers,
       help(SimulateOptionsText::tr("Share of these that take effect but get no response")));
  count("--map-latency-ms", f.map_latency_ms,
        help(SimulateOptionsText::tr("Delay of every response about maps")), 600'000);
  const auto flag = [&](const char* name, bool& value, const std::string& what) {
    command->add_flag(name, value, what)->group(faults);
  };
  flag("--truncated-maps", f.truncated_maps,
       help(SimulateOptionsText::tr("Cut off every map's PNG half-way")));
  flag("--lying-map-size", f.lying_map_size,
       help(SimulateOptionsText::tr("Every map's PNG declares 60,000 x 60,000 pixels")));
  flag("--foreign-data-url", f.foreign_data_url,
       help(SimulateOptionsText::tr("data_url points to another host")));
  flag("--garbage-base64", f.garbage_base64,
       help(SimulateOptionsText::tr("Pictures in topics are not valid base64")));
  flag("--map-list-error", f.map_list_error,
       help(SimulateOptionsText::tr("Answer 500 for the list of maps")));
  command
      ->add_option("--grid-fault", f.grid_fault,
                   help(SimulateOptionsText::tr("What is wrong with every map's place and resolution")))
      ->check(CLI::IsMember({"zero-resolution", "negative-resolution", "no-resolution", "no-origin"}))
      ->group(faults);
  addRosRobot(*command, o.ros);
  addRosFaults(*command, f.ros);
  addDispatcher(*command, o.ros.dispatcher);
  addDispatcherFaults(*command, f.ros.dispatcher);
  commands.add(command, [words](const Invocation&) { return simulate(*words); });
}

}  // namespace mapwright::app
