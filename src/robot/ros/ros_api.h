// Message definitions from rosapi (/rosapi/message_details), in the text form used in recordings. Pure.
// Sources: rosapi_msgs/TypeDef; MCAP, "Well-known schema encodings" (ros1msg, ros2msg).
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
#include "net/rosbridge/field.h"
#include "robot/ros/dispatch_names.h"
#include "robot/ros/ros_topics.h"

namespace mapwright::robot::ros {

struct RosDefinition {
  bool ros2 = false;
  std::string
      text;  // the fields of the type, followed by those of all types in it, separated by lines of '='
};

/// `typedefs` as received; the first is the requested type. nullopt: invalid, or it refers to missing types.
/// Constants are left out: rosapi does not give their types.
std::optional<RosDefinition> definitionIn(const net::rosbridge::Field& typedefs);

/// For a type whose only field is `name`, of the type `type` described by `inner`.
RosDefinition definitionAround(const RosDefinition& inner, const std::string& type, const std::string& name);

/// What the robot has. nullopt: the robot does not list them, or (`…_silent`) there was no answer at all, so
/// nothing is known.
struct RosGraph {
  std::optional<std::vector<Endpoint>> topics;
  std::optional<std::vector<std::string>> services;
  bool topics_silent = false, services_silent = false;
  std::vector<std::string> map_services;  // those of type nav_msgs/GetMap, better ones first
  /// Those that may belong to a dispatcher; nullopt like the services.
  std::optional<std::vector<Endpoint>> dispatch_services = {};
  /// Topics of projected maps without a publisher: the server lists them as long as anybody subscribes,
  /// including mapwright.
  std::set<std::string> unsent = {};
  bool operator==(const RosGraph&) const = default;
};

/// The namespace of a KABAM map manager ("/map_manager"), preferably below `ns`.
std::optional<std::string> mapManagerIn(const RosGraph& found, const std::string& ns);
/// The type of a topic as the server writes it; empty if unknown.
std::string typeOf(const RosGraph& found, const std::string& topic);
/// Without topics that have no publisher.
std::optional<std::vector<Endpoint>> sentTopics(const RosGraph& found);
bool lists(const RosGraph& found, const std::string& topic);

/// Lives on the link's thread.
class RosApi : public QObject {
  Q_OBJECT
 public:
  RosApi(net::rosbridge::Client& client, std::chrono::milliseconds timeout);

  /// Requests all topics with their types, and all services. Those below `ns` come first.
  void look(const std::string& ns, const DispatchSettings& dispatch, std::function<void(RosGraph)> then);
  /// The number of publishers of the topic; nullopt: unknown.
  void countPublishers(const std::string& topic, std::function<void(std::optional<std::size_t>)> then);
  /// The definition of this message type ("nav_msgs/Path", "nav_msgs/msg/Path"); nullopt: unknown.
  void define(const std::string& type, std::function<void(std::optional<RosDefinition>)> then);
  /// Whether a map manager answers at `manager_ns`, if services are not listed; nullopt: no answer.
  void probeMapManager(const std::string& manager_ns, std::function<void(std::optional<bool>)> then);

 private:
  struct Look {
    RosGraph found;
    int waits_for = 0;
    int senders_asked = 0;
    std::function<void(RosGraph)> then;
  };
  using LookPtr = std::shared_ptr<Look>;
  void ask(const char* service, const QByteArray& args, net::rosbridge::Client::Reply reply);
  /// The type of a "topic" or "service", which may be known from before.
  void askType(const LookPtr& look, const char* kind, const std::string& name,
               std::function<void(const std::string& type)> then);
  void askTypes(const LookPtr& look);
  void askWhoSends(const LookPtr& look, const Endpoint& topic);
  void askServiceTypes(const LookPtr& look, const std::string& ns, const DispatchSettings& dispatch);
  void step(const LookPtr& look);

  net::rosbridge::Client& client_;
  std::chrono::milliseconds timeout_;
  std::map<std::pair<std::string, std::string>, std::string>
      types_;  // requested one by one, by kind and name
};

}  // namespace mapwright::robot::ros
