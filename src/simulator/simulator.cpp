#include "simulator/simulator.h"

#include <cmath>
#include <mutex>

#include "simulator/axbot_server.h"
#include "simulator/made.h"
#include "simulator/ros/ros_server.h"

namespace mapwright::simulator {
namespace {

std::optional<std::string> problemOf(const Options& options, bool scene_exists) {
  if (!scene_exists) {
    std::string names;
    for (const auto& [name, sentence] : sceneNames()) names += (names.empty() ? "" : ", ") + name;
    return "There is no scene \"" + options.scene + "\". Choose one of: " + names + ".";
  }
  const auto lies = [](double value, double low, double high) { return value >= low && value <= high; };
  const double edge_m = options.ros.dispatcher.edge_m;
  const std::pair<bool, std::string> checks[] = {
      {lies(options.submaps, 0, kMostSubmaps),
       "The number of submaps must lie between 0 and " + std::to_string(kMostSubmaps) + "."},
      {lies(options.speed, 0, 1e6),
       "The speed must lie between 0 and 1,000,000 simulated seconds per second."},
      {lies(options.start_at_s, 0, 1e8), "The start must lie between 0 and 100,000,000 simulated seconds."},
      {lies(options.points_per_scan, 0, 1e6),
       "The number of points in a scan must lie between 0 and 1,000,000."},
      {options.scan_hz > 0 && options.scan_hz <= 100 && options.pose_hz > 0 && options.pose_hz <= 100,
       "Scans and poses come more than 0 and at most 100 times a second."},
      {lies(options.costmap_cells, 20, 4000), "The edge of a costmap must lie between 20 and 4000 cells."},
      {lies(options.ros.waypoints, 0, 100'000), "The number of waypoints must lie between 0 and 100,000."},
      {lies(edge_m, 10, 2000) && edge_m == std::floor(edge_m),
       "The building of the map dispatcher has an edge of whole metres between 10 and 2000."}};
  for (const auto& [fine, sentence] : checks) {
    if (!fine) return sentence;
  }
  return std::nullopt;
}

}  // namespace

class Simulator::Impl {
 public:
  explicit Impl(Options chosen) : Impl(chosen, madeFor(chosen)) {}

  void publish() {
    const std::lock_guard lock(server_mutex);
    if (server) server->publishList();
    if (ros_server) ros_server->refresh();
  }

  template <typename Edit>
  void edit(const Edit& how) {
    how(state);
    publish();
  }

  /// Does something with a server; `otherwise` while none runs.
  template <typename Server, typename Result>
  Result with(const std::unique_ptr<Server>& one, Result (Server::*does)() const, Result otherwise) const {
    const std::lock_guard lock(server_mutex);
    return one ? (one.get()->*does)() : otherwise;
  }
  template <typename... Arguments>
  void notifyRos(void (ros::RosServer::*what)(Arguments...), Arguments... arguments) {
    const std::lock_guard lock(server_mutex);
    if (ros_server) (ros_server.get()->*what)(arguments...);
  }

  const Options options;
  const std::optional<std::string> problem;
  const std::shared_ptr<MadeOfScene> made;
  RobotState state;
  MapLibrary library;
  MappingTasks mappings;
  BagStore bags;
  BodyCache bodies{kBodiesKept};
  FaultPlan faults;
  RequestLog log;
  ros::KabamStore kabam;
  mutable std::mutex server_mutex;
  std::unique_ptr<AxbotServer> server;
  std::unique_ptr<ros::RosServer> ros_server;

 private:
  static std::shared_ptr<MadeOfScene> madeFor(const Options& options) {
    if (options.submaps < 0 || options.submaps > kMostSubmaps) return std::make_shared<MadeOfScene>(Scene{});
    return madeOf(options.scene, options.submaps, options.seed);
  }
  Impl(const Options& chosen, std::shared_ptr<MadeOfScene> found)
      : options(chosen),
        problem(problemOf(chosen, found != nullptr)),
        made(problem ? std::make_shared<MadeOfScene>(Scene{}) : std::move(found)),
        state(made->scene, chosen.seed, {chosen.start_at_s, chosen.speed, chosen.paused}),
        library(state, made->pictures, chosen.seed),
        mappings(state),
        bags(state, library, options),
        faults(chosen.faults, chosen.seed),
        kabam(state, made->pictures, faults, options) {}
};

Simulator::Simulator(Options options) : impl_(std::make_unique<Impl>(std::move(options))) {}

Simulator::~Simulator() { stop(); }

std::optional<std::string> Simulator::start() {
  if (impl_->problem) return impl_->problem;
  const std::lock_guard lock(impl_->server_mutex);
  if (impl_->server) return std::nullopt;
  auto server =
      std::make_unique<AxbotServer>(Robot{impl_->options, impl_->state, impl_->library, impl_->mappings,
                                          impl_->bags, *impl_->made, impl_->bodies, impl_->faults},
                                    impl_->log);
  if (std::optional<std::string> failure = server->start(impl_->options.port, impl_->options.aimdk_port))
    return failure;
  auto ros_server = std::make_unique<ros::RosServer>(impl_->options, impl_->state, impl_->faults, impl_->log,
                                                     impl_->kabam, impl_->made->pictures);
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

std::uint16_t Simulator::port() const {
  return impl_->with(impl_->server, &AxbotServer::port, std::uint16_t{0});
}

std::string Simulator::address() const { return "axbot+http://127.0.0.1:" + std::to_string(port()); }

std::uint16_t Simulator::aimdkPort() const {
  return impl_->with(impl_->server, &AxbotServer::aimdkPort, std::uint16_t{0});
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
  impl_->edit([&](RobotState& state) { state.advance(simulated_s); });
}

void Simulator::closeLoop() {
  impl_->edit([](RobotState& state) { state.closeLoop(); });
}

void Simulator::restartSlam() {
  impl_->edit([](RobotState& state) { state.restartSlam(); });
}

void Simulator::removeSubmap(int trajectory, int index) {
  impl_->edit([&](RobotState& state) { state.remove({trajectory, index}); });
}

void Simulator::bumpVersion(int trajectory, int index) {
  impl_->edit([&](RobotState& state) { state.bump({trajectory, index}); });
}

void Simulator::dropWebSockets() {
  const std::lock_guard lock(impl_->server_mutex);
  if (impl_->server) impl_->server->dropWebSockets();
  if (impl_->ros_server) impl_->ros_server->dropLinks();
}

void Simulator::stallRos() { impl_->notifyRos(&ros::RosServer::stall, true); }

void Simulator::unstallRos() { impl_->notifyRos(&ros::RosServer::stall, false); }

void Simulator::publishMapChange() { impl_->library.change(); }

bool Simulator::setCurrentMap(int id) { return impl_->library.setCurrent(id); }

std::string Simulator::uuid() const { return impl_->state.uuid(); }

int Simulator::openWebSockets() const { return impl_->with(impl_->server, &AxbotServer::openWebSockets, 0); }

int Simulator::openRosLinks() const { return impl_->with(impl_->ros_server, &ros::RosServer::openLinks, 0); }

void Simulator::otherPainter() { impl_->notifyRos(&ros::RosServer::otherPainter); }

void Simulator::otherOperator() { impl_->notifyRos(&ros::RosServer::otherOperator); }

}  // namespace mapwright::simulator
