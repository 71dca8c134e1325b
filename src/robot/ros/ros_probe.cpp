#include "robot/ros/ros_probe.h"

#include <algorithm>
#include <utility>

#include "robot/ros/faults.h"
#include "robot/ros/ros_address.h"

namespace mapwright::robot::ros {
namespace {

constexpr quint64 kLongestAnswer = quint64(16) << 20;
constexpr const char* kUsualManager = "/map_manager";

net::rosbridge::ClientOptions askingOptions(std::chrono::milliseconds within) {
  net::rosbridge::ClientOptions options;
  options.link.connect_timeout = within;
  options.max_message_bytes = kLongestAnswer;
  return options;
}

/// One server that is asked. Destroyed with its owner, or when it has answered.
class AskingRos : public QObject {
 public:
  AskingRos(QObject* owner, QUrl server, std::chrono::milliseconds within, Probe::Reply reply)
      : QObject(owner),
        server_(std::move(server)),
        reply_(std::move(reply)),
        client_(server_, askingOptions(within)),
        api_(client_, within * 2 / 3) {
    connect(&client_, &net::rosbridge::Client::opened, this, [this] {
      if (std::exchange(opened_, true)) return;
      api_.look({}, {}, [this](RosGraph graph) { onGraph(std::move(graph)); });
    });
    connect(&client_, &net::rosbridge::Client::changed, this, [this] {
      const net::WebSocketLink& link = client_.link();
      if (link.failure() == net::WebSocketLink::Failure::None) return;
      opened_ ? end({{wantsSecret()}, {}}) : end({{}, link.reason()});
    });
    client_.open();
  }

 private:
  void onGraph(RosGraph graph) {
    if (graph.topics || graph.services) return end({robotsIn(graph, server_), {}});
    const bool silent = graph.topics_silent && graph.services_silent;
    // Without rosapi nothing is listed; whether a map manager answers can be asked.
    api_.probeMapManager(kUsualManager, [this, silent](std::optional<bool> there) {
      if (silent && !there)
        return end(
            {{},
             {faultText("ros", "a WebSocket opens there, but nothing answers the requests of rosbridge")},
             true});
      RosGraph usual;
      if (there.value_or(false)) usual.services = {std::string(kUsualManager) + "/load_map"};
      std::vector<FoundRobot> robots = robotsIn(usual, server_);
      for (FoundRobot& robot : robots) robot.services.reset();
      end({std::move(robots), {}});
    });
  }
  /// It accepts connections and ends them: that is how a server answers who has to say the secret first.
  FoundRobot wantsSecret() const {
    return {.address = rosAddressScheme().prefix + server_.toString(), .wants_secret = true};
  }
  void end(ProbeAnswer answer) {
    if (!reply_) return;
    // The client may be in the middle of telling.
    QMetaObject::invokeMethod(
        this,
        [this, reply = std::exchange(reply_, nullptr), answer = std::move(answer)] {
          deleteLater();
          reply(answer);
        },
        Qt::QueuedConnection);
  }

  QUrl server_;
  Probe::Reply reply_;
  net::rosbridge::Client client_;
  RosApi api_;
  bool opened_ = false;
};

Probe probeOf(const QUrl& server) {
  return {rosAddressScheme().title, server,
          [server](QObject* owner, std::chrono::milliseconds within, Probe::Reply reply) {
            new AskingRos(owner, server, within, std::move(reply));
          }};
}

/// "ROS 1", "ROS 2": types are written in different ways.
QString generationIn(const RosGraph& graph) {
  if (!graph.topics) return {};
  const auto any = [&](const char* text) {
    return std::any_of(graph.topics->begin(), graph.topics->end(),
                       [&](const Endpoint& topic) { return topic.type.find(text) != std::string::npos; });
  };
  return any("/msg/") ? QStringLiteral("ROS 2") : any("/") ? QStringLiteral("ROS 1") : QString();
}

}  // namespace

std::vector<Probe> probesOf(const Host& host) {
  const AddressScheme scheme = rosAddressScheme();
  return {probeOf(serverAt(scheme.plain, host, scheme.port)),
          probeOf(serverAt(scheme.encrypted, host, scheme.port))};
}

std::vector<FoundRobot> robotsIn(const RosGraph& graph, const QUrl& server) {
  std::vector<FoundRobot> robots;
  const auto add = [&](const AddressScheme& scheme, const std::string& ns) {
    FoundRobot robot;
    robot.address = scheme.prefix + server.toString();
    if (!ns.empty()) robot.address += QStringLiteral("?ns=") + QString::fromStdString(ns);
    robot.identity.version = generationIn(graph);
    if (graph.topics) robot.topics = std::int64_t(graph.topics->size());
    if (graph.services) robot.services = std::int64_t(graph.services->size());
    robots.push_back(std::move(robot));
  };
  if (const auto manager = mapManagerIn(graph, {}))
    add(kabamAddressScheme(), manager->substr(0, manager->rfind('/')));
  if (dispatcherIn(graph.dispatch_services, graph.topics, {}).any()) add(rep130AddressScheme(), {});
  add(rosAddressScheme(), {});
  return robots;
}

}  // namespace mapwright::robot::ros
