// The simulated ROS robot without its sockets: its topics with their rates and types, and its services.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simulator/ros/dispatcher.h"
#include "simulator/ros/kabam_store.h"
#include "simulator/ros/message_types.h"
#include "simulator/ros/ros_messages.h"

namespace mapwright::simulator::ros {

struct TopicRow {
  std::string_view name, type;  // "nav_msgs/Path", without the word in the middle
  double period_s = 0;          // 0: when it changes
  bool latched = false;         // the last message is sent to who comes later
  bool slow = false;            // takes many milliseconds to make
  /// Null where the robot only listens (what is published there reaches all who subscribed), and for the
  /// topics of the dispatcher.
  Value (*make)(const Moment& moment) = nullptr;
};

/// The topics of the map manager.
inline constexpr std::string_view kMapInfoTopic = "/map_manager/current_map_info";
inline constexpr std::string_view kMapListTopic = "/map_manager/map_list";
inline constexpr std::string_view kArchivedListTopic = "/map_manager/archived_map_list";
inline constexpr std::string_view kWaypointsTopic = "/map_manager/current_map_waypoints";

/// Safe from any thread: slow topics are made by workers.
class RosRobot {
 public:
  RosRobot(const Options& options, const RobotState& robot, const FaultPlan& faults, KabamStore& kabam,
           MapPictures& pictures);

  /// All topics that it may ever have.
  const std::vector<TopicRow>& topics() const { return topics_; }
  const TopicRow* topic(std::string_view name) const;
  /// As the faults leave it.
  std::string_view typeOf(const TopicRow& topic) const;
  /// Null if there is nothing to send: no map, nothing that grows.
  Value messageOf(std::string_view topic);

  /// `args` as sent by the client: an object, a list in the order of the fields, or nothing.
  Answer call(std::string_view name, const Value& args, const Verdict& verdict);
  /// What kinds of Requests the calls of a service are.
  unsigned kindsOf(std::string_view service) const;
  const MessageTypes& types() const { return types_; }
  Dispatcher::Edits dispatcherEdits() const { return dispatcher_.edits(); }

 private:
  std::vector<Service> allServices();
  const Service* service(std::string_view name) const;
  std::vector<TopicRow> presentTopics() const;
  std::string wireType(const TopicRow& topic) const;
  std::string wireType(const Service& service) const;
  Moment momentOf(const RosFaults& faults);

  const Options& options_;
  const RobotState& robot_;
  const FaultPlan& faults_;
  KabamStore& kabam_;
  MapPictures& pictures_;
  Dispatcher dispatcher_;
  const MessageTypes types_;
  const std::vector<TopicRow> topics_;
  const std::vector<Service> services_;
  CostsCache costs_{1};
};

}  // namespace mapwright::simulator::ros
