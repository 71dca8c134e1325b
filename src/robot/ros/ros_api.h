// What a rosbridge server tells of the robot behind it, by its node rosapi, which may be absent.
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

/// nullopt: the robot does not tell, or (`…_silent`) nothing was heard at all, so nothing is known.
struct Found {
  std::optional<std::vector<FoundTopic>> topics;
  std::optional<std::vector<std::string>> services;
  bool topics_silent = false, services_silent = false;
  std::vector<std::string> map_services;  // those of type nav_msgs/GetMap, the better ones first
  /// Those that may be a dispatcher's; nullopt like the services.
  std::optional<std::vector<TypedService>> dispatch_services = {};
  /// Topics of projected maps that no node sends by: the server goes on listing them as long as anybody
  /// listens, mapwright included.
  std::set<std::string> unsent = {};
  bool operator==(const Found&) const = default;
};

/// Where a KABAM map manager is ("/map_manager"), below `ns` rather than elsewhere.
std::optional<std::string> mapManagerIn(const Found& found, const std::string& ns);
/// The type of a topic as the server writes it; empty where it does not say.
std::string typeOf(const Found& found, const std::string& topic);
/// Without those that nobody sends by.
std::optional<std::vector<FoundTopic>> sentTopics(const Found& found);
bool lists(const Found& found, const std::string& topic);

/// Lives on the link's thread.
class RosApi : public QObject {
  Q_OBJECT
 public:
  RosApi(net::rosbridge::Client& client, std::chrono::milliseconds patience);

  /// Asks for all topics with their types, and all services. What lies below `ns` goes first.
  void look(const std::string& ns, const DispatchWish& dispatch, std::function<void(Found)> then);
  /// How many nodes send by the topic; nullopt: it does not tell.
  void countPublishers(const std::string& topic, std::function<void(std::optional<std::size_t>)> then);
  /// What messages of this type ("nav_msgs/Path", "nav_msgs/msg/Path") are made of; nullopt: it does not
  /// tell.
  void define(const std::string& type, std::function<void(std::optional<RosDefinition>)> then);
  /// Whether a map manager answers at `place`, where nobody tells which services there are; nullopt: nothing
  /// was heard.
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
  std::map<std::string, std::string> types_;          // asked for one by one, by topic
  std::map<std::string, std::string> service_types_;  // likewise
};

}  // namespace mapwright::robot::ros
