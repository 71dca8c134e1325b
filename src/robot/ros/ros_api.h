// The topics and services of a robot, from the node rosapi of its rosbridge server, which may not be running.
// Source: docs/protocols/rosbridge.md, "What the robot has (rosapi)".
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <QObject>

#include "net/rosbridge/client.h"
#include "robot/ros/dispatch_names.h"
#include "robot/ros/ros_definition.h"
#include "robot/ros/ros_topics.h"

namespace mapwright::robot::ros {

/// nullopt: the robot does not list them, or (`…_silent`) there was no answer at all, so nothing is known.
struct Found {
  std::optional<std::vector<FoundTopic>> topics;
  std::optional<std::vector<std::string>> services;
  bool topics_silent = false, services_silent = false;
  std::vector<std::string> map_services;  // those of type nav_msgs/GetMap, better ones first
  /// Those that may belong to a dispatcher; nullopt like the services.
  std::optional<std::vector<TypedService>> dispatch_services = {};
  /// Topics of projected maps without a publisher: the server lists them as long as anybody subscribes,
  /// including mapwright.
  std::set<std::string> unsent = {};
  bool operator==(const Found&) const = default;
};

/// The namespace of a KABAM map manager ("/map_manager"), preferably below `ns`.
std::optional<std::string> mapManagerIn(const Found& found, const std::string& ns);
/// The type of a topic as the server writes it; empty if unknown.
std::string typeOf(const Found& found, const std::string& topic);
/// Without topics that have no publisher.
std::optional<std::vector<FoundTopic>> sentTopics(const Found& found);
bool lists(const Found& found, const std::string& topic);

/// Lives on the link's thread.
class RosApi : public QObject {
  Q_OBJECT
 public:
  RosApi(net::rosbridge::Client& client, std::chrono::milliseconds patience);

  /// Requests all topics with their types, and all services. Those below `ns` come first.
  void look(const std::string& ns, const DispatchWish& dispatch, std::function<void(Found)> then);
  /// The number of publishers of the topic; nullopt: unknown.
  void countPublishers(const std::string& topic, std::function<void(std::optional<std::size_t>)> then);
  /// The definition of this message type ("nav_msgs/Path", "nav_msgs/msg/Path"); nullopt: unknown.
  void define(const std::string& type, std::function<void(std::optional<RosDefinition>)> then);
  /// Whether a map manager answers at `place`, if services are not listed; nullopt: no answer.
  void probeMapManager(const std::string& place, std::function<void(std::optional<bool>)> then);

 private:
  struct Look {
    Found found;
    int waits_for = 0;
    int senders_asked = 0;
    std::function<void(Found)> then;
  };
  using LookPtr = std::shared_ptr<Look>;
  void ask(const char* service, const QByteArray& args, net::rosbridge::Client::Reply reply);
  void askTypes(const LookPtr& look);
  void askWhoSends(const LookPtr& look, const FoundTopic& topic);
  void askServiceTypes(const LookPtr& look, const std::string& ns, const DispatchWish& dispatch);
  void step(const LookPtr& look);

  net::rosbridge::Client& client_;
  std::chrono::milliseconds patience_;
  std::map<std::string, std::string> types_;          // requested one by one, by topic
  std::map<std::string, std::string> service_types_;  // likewise
};

}  // namespace mapwright::robot::ros
