// The services of the simulated ROS robot: the map manager, the map server, rosapi.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "simulator/ros/dispatcher.h"
#include "simulator/ros/kabam_store.h"
#include "simulator/ros/message_types.h"
#include "simulator/ros/ros_messages.h"
#include "simulator/ros/topic_table.h"

namespace mapwright::simulator::ros {

/// The result of a call. If the call itself failed, `values` is a text.
struct CallOutcome {
  bool worked = false;
  Value values;
};

/// Safe from any thread.
class Services {
 public:
  Services(const Options& options, const FaultPlan& faults, KabamStore& kabam, Messages& messages,
           Dispatcher& dispatcher)
      : options_(options),
        faults_(faults),
        kabam_(kabam),
        messages_(messages),
        dispatcher_(dispatcher),
        types_(options.ros.dialect) {}

  bool has(std::string_view service) const;
  /// `args` as sent by the client: an object, a list in the order of the fields, or nothing.
  CallOutcome call(std::string_view name, const Value& args);
  const MessageTypes& types() const { return types_; }

 private:
  struct Row {
    std::string_view name, type;  // "kabam_msgs/LoadMap"
  };
  std::vector<Row> rows() const;
  std::string typeOf(const Row& row) const;
  Value answer(std::string_view service, const Value& request);
  Value answerManager(std::string_view verb, const Value& request);
  std::vector<TopicRow> topics() const;
  Value answerRosapi(std::string_view verb, const Value& request) const;
  Value waypointsOf(const std::string& map_id, const std::string& waypoint_id) const;

  const Options& options_;
  const FaultPlan& faults_;
  KabamStore& kabam_;
  Messages& messages_;
  Dispatcher& dispatcher_;
  const MessageTypes types_;
};

}  // namespace mapwright::simulator::ros
