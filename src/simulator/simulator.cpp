#include "simulator/simulator.h"

#include <cmath>
#include <mutex>

#include "simulator/ros/ros_server.h"
#include "simulator/server.h"

namespace mapwright::simulator {
namespace {

std::optional<std::string> problemOf(const Options& options, bool scene_exists) {
  if (!scene_exists) {
    std::string names;
    for (const auto& [name, sentence] : sceneNames()) names += (names.empty() ? "" : ", ") + name;
    return "There is no scene \"" + options.scene + "\". Choose one of: " + names + ".";
  }
  if (options.submaps < 0 || options.submaps > kMostSubmaps) {
    return "The number of submaps must lie between 0 and " + std::to_string(kMostSubmaps) + ".";
  }
  if (!std::isfinite(options.speed) || options.speed < 0 || options.speed > 1e6) {
    return "The speed must lie between 0 and 1,000,000 simulated seconds per second.";
  }
  if (!std::isfinite(options.start_at_s) || options.start_at_s < 0 || options.start_at_s > 1e8) {
    return "The start must lie between 0 and 100,000,000 simulated seconds.";
  }
  if (options.points_per_scan < 0 || options.points_per_scan > 1'000'000) {
    return "The number of points in a scan must lie between 0 and 1,000,000.";
  }
  for (const double hz : {options.scan_hz, options.pose_hz}) {
    if (!(hz > 0 && hz <= 100)) return "Scans and poses come more than 0 and at most 100 times a second.";
  }
  if (options.costmap_cells < 20 || options.costmap_cells > 4000) {
    return "The edge of a costmap must lie between 20 and 4000 cells.";
  }
  if (options.ros.waypoints < 0 || options.ros.waypoints > 100'000) {
    return "The number of waypoints must lie between 0 and 100,000.";
  }
  if (const double edge = options.ros.dispatcher.edge_m;
      !(edge >= 10 && edge <= 2000 && edge == std::floor(edge))) {
    return "The building of the map dispatcher has an edge of whole metres between 10 and 2000.";
  }
  return std::nullopt;
}

}  // namespace

class Simulator::Impl {
 public:
  explicit Impl(Options chosen) : Impl(chosen, sceneFor(chosen)) {}

  void publish() {
    const std::lock_guard lock(server_mutex);
    if (server) server->publishList();
    if (ros_server) ros_server->refresh();
  }

  /// Does something with a server; `otherwise` while none runs.
  template <typename Server, typename Result>
  Result with(const std::unique_ptr<Server>& one, Result (Server::*does)() const, Result otherwise) const {
    const std::lock_guard lock(server_mutex);
    return one ? (one.get()->*does)() : otherwise;
  }
  template <typename... Arguments>
  void tellRos(void (ros::RosServer::*what)(Arguments...), Arguments... arguments) {
    const std::lock_guard lock(server_mutex);
    if (ros_server) (ros_server.get()->*what)(arguments...);
  }

  const Options options;
  const std::optional<std::string> problem;
  RobotState state;
  MapLibrary library;
  MappingTasks mappings;
  FaultPlan faults;
  RequestLog log;
  MapPictures ros_pictures;
  ros::KabamStore kabam;
  mutable std::mutex server_mutex;
  std::unique_ptr<Server> server;
  std::unique_ptr<ros::RosServer> ros_server;

 private:
  static std::optional<Scene> sceneFor(const Options& options) {
    if (options.submaps < 0 || options.submaps > kMostSubmaps) return Scene{};
    return makeScene(options.scene, options.submaps, options.seed);
  }
  Impl(const Options& chosen, std::optional<Scene> scene)
      : options(chosen),
        problem(problemOf(chosen, scene.has_value())),
        state(problem || !scene ? Scene{} : std::move(*scene), chosen.seed,
              {chosen.start_at_s, chosen.speed, chosen.paused}),
        library(state, chosen.seed),
        mappings(state),
        faults(chosen.faults, chosen.seed),
        ros_pictures(state.scene()),
        kabam(state, ros_pictures, chosen.ros, chosen.seed) {}
};

Simulator::Simulator(Options options) : impl_(std::make_unique<Impl>(std::move(options))) {}

Simulator::~Simulator() { stop(); }

std::optional<std::string> Simulator::start() {
  if (impl_->problem) return impl_->problem;
  const std::lock_guard lock(impl_->server_mutex);
  if (impl_->server) return std::nullopt;
  auto server = std::make_unique<Server>(
      Robot{impl_->options, impl_->state, impl_->library, impl_->mappings, impl_->faults}, impl_->log);
  if (std::optional<std::string> failure = server->start(impl_->options.port, impl_->options.aimdk_port))
    return failure;
  auto ros_server = std::make_unique<ros::RosServer>(impl_->options, impl_->state, impl_->faults, impl_->log,
                                                     impl_->kabam, impl_->ros_pictures);
  if (std::optional<std::string> failure = ros_server->start(impl_->options.ros.port)) return failure;
  impl_->server = std::move(server);
  impl_->ros_server = std::move(ros_server);
  return std::nullopt;
}

void Simulator::stop() {
  const std::lock_guard lock(impl_->server_mutex);
  impl_->server.reset();
  impl_->ros_server.reset();
}

std::uint16_t Simulator::port() const { return impl_->with(impl_->server, &Server::port, std::uint16_t{0}); }

std::string Simulator::address() const { return "axbot+http://127.0.0.1:" + std::to_string(port()); }

std::uint16_t Simulator::aimdkPort() const {
  return impl_->with(impl_->server, &Server::aimdkPort, std::uint16_t{0});
}

std::string Simulator::aimdkAddress() const {
  return "aimdk+http://127.0.0.1:" + std::to_string(aimdkPort());
}

std::uint16_t Simulator::rosPort() const {
  return impl_->with(impl_->ros_server, &ros::RosServer::port, std::uint16_t{0});
}

std::string Simulator::rosAddress() const { return "ros+ws://127.0.0.1:" + std::to_string(rosPort()); }

std::string Simulator::kabamAddress() const { return "kabam+ws://127.0.0.1:" + std::to_string(rosPort()); }

std::string Simulator::rep130Address() const { return "rep130+ws://127.0.0.1:" + std::to_string(rosPort()); }

std::vector<RequestRecord> Simulator::requestLog() const { return impl_->log.records(); }

void Simulator::clearRequestLog() { impl_->log.clear(); }

void Simulator::setFaults(const Faults& faults) {
  impl_->faults.setFaults(faults);
  impl_->publish();
}

void Simulator::advance(double simulated_s) {
  impl_->state.advance(simulated_s);
  impl_->publish();
}

void Simulator::closeLoop() {
  impl_->state.closeLoop();
  impl_->publish();
}

void Simulator::restartSlam() {
  impl_->state.restartSlam();
  impl_->publish();
}

void Simulator::dropWebSockets() {
  const std::lock_guard lock(impl_->server_mutex);
  if (impl_->server) impl_->server->dropWebSockets();
  if (impl_->ros_server) impl_->ros_server->dropLinks();
}

void Simulator::stallRos() { impl_->tellRos(&ros::RosServer::stall, true); }

void Simulator::unstallRos() { impl_->tellRos(&ros::RosServer::stall, false); }

void Simulator::removeSubmap(int trajectory, int index) {
  impl_->state.remove({trajectory, index});
  impl_->publish();
}

void Simulator::bumpVersion(int trajectory, int index) {
  impl_->state.bump({trajectory, index});
  impl_->publish();
}

void Simulator::publishMapChange() { impl_->library.change(); }

bool Simulator::setCurrentMap(int id) { return impl_->library.setCurrent(id); }

std::string Simulator::uuid() const { return impl_->state.uuid(); }

int Simulator::openWebSockets() const { return impl_->with(impl_->server, &Server::openWebSockets, 0); }

int Simulator::openRosLinks() const { return impl_->with(impl_->ros_server, &ros::RosServer::openLinks, 0); }

void Simulator::otherPainter() { impl_->tellRos(&ros::RosServer::otherPainter); }

void Simulator::otherOperator() { impl_->tellRos(&ros::RosServer::otherOperator); }

}  // namespace mapwright::simulator
